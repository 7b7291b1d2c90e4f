#pragma once

#include "server/room/match.hpp"
#include "server/store/replay_store.hpp"
#include "shared/result.hpp"

#include <string>

namespace poolhall::server {

/// A match as it stood when its log ended. Every shot is played again by the rules and must give
/// the logged hashes and ruling; a shot that was durable but not yet shown is part of the history.
/// All seats are reserved, nobody is connected. The error is one sentence that names the shot.
[[nodiscard]] Result<Match, std::string> rebuild(const StoredMatch& stored);

}  // namespace poolhall::server
