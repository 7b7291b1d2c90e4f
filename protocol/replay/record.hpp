#pragma once

#include "shared/game/game_state.hpp"
#include "shared/game/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// What the server logs of a match, in order. REPLAY_FORMAT.md describes the bytes; kKind is a
// record's "kind".
namespace poolhall::protocol {

inline constexpr std::string_view kReplayFormat = "poolhall.replay/1";
/// More event times than this are not kept: a record must fit into a line of a replay file.
inline constexpr std::size_t kMaxEventTimes = 10000;

/// The first record of a match.
struct MatchRecord {
    static constexpr std::string_view kKind = "match";
    std::string match;                       ///< id: 1 to 64 of A-Z a-z 0-9 _ -
    std::string game;                        ///< ruleset
    std::string server;                      ///< program and version that wrote it
    std::int64_t created_ms = 0;             ///< Unix time, ms
    std::optional<GameSettings> settings{};  ///< absent: every game is played with its own physics
};

/// A seat was taken or left (empty name).
struct SeatRecord {
    static constexpr std::string_view kKind = "seat";
    Seat seat;
    std::string name;
};

/// A game begins, its first shot by `first`.
struct GameRecord {
    static constexpr std::string_view kKind = "game";
    std::uint32_t game_number = 1;
    Seat first;
};

/// A shot, complete: `scene` has its strike, so that it can be simulated again by itself.
struct ShotRecord {
    static constexpr std::string_view kKind = "shot";
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
    /// s; the time of each event, so that a divergence can be traced to its first event. Empty if
    /// not kept.
    std::vector<double> event_times{};
};

/// The match was closed; nothing follows.
struct EndRecord {
    static constexpr std::string_view kKind = "end";
    std::string reason;
    std::int64_t at_ms = 0;
};

using ReplayRecord = std::variant<MatchRecord, SeatRecord, GameRecord, ShotRecord, EndRecord>;

/// A record and its place in the match: 1, 2, 3, ... without a gap.
struct NumberedRecord {
    std::uint64_t n = 0;
    ReplayRecord record;
};

/// The record's kKind.
[[nodiscard]] std::string_view kind_of(const ReplayRecord& record);

/// The record of a shot that the rules have just played; its numbers within the match and its time
/// are left at 0.
[[nodiscard]] ShotRecord shot_record(const ShotOutcome& outcome);

}  // namespace poolhall::protocol
