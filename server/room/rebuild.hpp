#pragma once

#include "server/room/table.hpp"
#include "server/store/replay_store.hpp"
#include "shared/result.hpp"

#include <string>

namespace poolhall::server {

/// A table as it stood when its log ended, of either version of the format. What LogFollower calls
/// a deviation is why there is none: one sentence that names the record. A shot that was durable
/// but not yet shown is part of the history. All seats are reserved, nobody is connected.
[[nodiscard]] Result<Table, std::string> rebuild(const StoredMatch& stored);

}  // namespace poolhall::server
