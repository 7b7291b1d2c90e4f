#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "shared/game/game_state.hpp"

// What the server logs of a match, in order. REPLAY_FORMAT.md describes the bytes.
namespace poolhall::protocol {

inline constexpr int kReplayVersion = 1;

/// The first record of a match.
struct MatchRecord {
    std::string match;            ///< id
    std::string game;             ///< ruleset
    std::string server;           ///< program and version that wrote it
    std::int64_t created_ms = 0;  ///< Unix time, ms
};

/// A seat was taken or left (empty name).
struct SeatRecord {
    Seat seat;
    std::string name;
};

/// A game begins, its first shot by `first`.
struct GameRecord {
    std::uint32_t game_number = 1;
    Seat first;
};

/// A shot, complete: `scene` has its strike, so that it can be simulated again by itself.
struct ShotRecord {
    std::uint32_t shot = 0;  ///< from 1, within the match
    std::uint32_t game_number = 1;
    Seat seat;
    Scene scene;
    std::uint64_t scene_hash = 0;
    std::string kernel;
    std::uint64_t final_hash = 0;
    double duration = 0;  ///< s
    std::uint32_t event_count = 0;
    Ruling ruling;
    std::int64_t at_ms = 0;  ///< Unix time, ms
};

/// The match was closed; nothing follows.
struct EndRecord {
    std::string reason;
    std::int64_t at_ms = 0;
};

using ReplayRecord = std::variant<MatchRecord, SeatRecord, GameRecord, ShotRecord, EndRecord>;

}  // namespace poolhall::protocol
