#pragma once

#include "server/room/table.hpp"
#include "server/store/replay_store.hpp"
#include "shared/result.hpp"

#include <string>

namespace poolhall::server {

/// A table as it stood when its log ended. Every move is played again by the rules and must give
/// the logged state; a shot that was durable but not yet shown is part of the history. All seats
/// are reserved, nobody is connected. The error is one sentence that names the move.
[[nodiscard]] Result<Table, std::string> rebuild(const StoredMatch& stored);

}  // namespace poolhall::server
