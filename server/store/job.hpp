#pragma once

#include "protocol/replay/record.hpp"

#include <functional>
#include <optional>
#include <string>
#include <variant>

// What can be asked of the replay store.
namespace poolhall::server {

/// Begins a match. Its id must be new, its code not that of another open match.
struct CreateMatchJob {
    std::string code;  ///< join code
    protocol::MatchRecord record;
};

/// Someone takes a seat, or leaves it (empty name and token hash).
struct SetSeatJob {
    std::string match;  ///< id
    protocol::SeatRecord record;
    std::string token_hash;  ///< private: never exported
};

struct AppendMoveJob {
    std::string match;  ///< id
    protocol::MoveRecord record;
};

/// Ends a match; its code is free again.
struct CloseMatchJob {
    std::string match;  ///< id
    protocol::EndRecord record;
};

using StoreJob = std::variant<CreateMatchJob, SetSeatJob, AppendMoveJob, CloseMatchJob>;

/// Nothing if a job was done, or one sentence why nothing of it was stored.
using JobFailure = std::optional<std::string>;

/// Hears what became of a job once that is certain: done means durable.
using StoreCompletion = std::function<void(JobFailure failure)>;

}  // namespace poolhall::server
