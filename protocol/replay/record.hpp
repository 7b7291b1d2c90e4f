#pragma once

#include "shared/analysis/effect_use.hpp"
#include "shared/match/match.hpp"

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

inline constexpr int kReplayVersion = 2;       ///< that is written
inline constexpr int kFirstReplayVersion = 1;  ///< the oldest that is read
/// More event times than this are not kept: a record must fit into a line of a replay file.
inline constexpr std::size_t kMaxEventTimes = 10000;

/// The first record of a match.
struct MatchRecord {
    static constexpr std::string_view kKind = "match";
    int version = kReplayVersion;             ///< of the format: "poolhall.replay/2"
    std::string match;                        ///< id: 1 to 64 of A-Z a-z 0-9 _ -
    std::string game;                         ///< ruleset
    std::string server;                       ///< program and version that wrote it
    std::int64_t created_ms = 0;              ///< Unix time, ms
    std::optional<MatchSettings> settings{};  ///< absent: every game is played with its own physics
    std::optional<Seat>
        first{};  ///< breaks in the first game; absent in version 1, which has GameRecord
};

/// A seat was taken or left (empty name).
struct SeatRecord {
    static constexpr std::string_view kKind = "seat";
    Seat seat;
    std::string name;
};

/// How a shot was simulated, and what shows whether it still gives the same.
struct ShotEvidence {
    std::uint32_t shot = 0;     ///< from 1, within the match
    std::uint32_t edition = 0;  ///< of the physics
    std::string solver;  ///< its name, and the kernel's: either may be gone in a later version
    std::string kernel;
    /// What the scene names, and what of it the shot called for. Not there in older records.
    std::optional<std::vector<analysis::EffectUse>> effects{};
    std::uint64_t trace = 0;  ///< hash of the events and the final states
    double duration = 0;      ///< s
    std::uint32_t event_count = 0;
    /// s; the time of each event, so that a divergence can be traced to its first event. Empty if
    /// not kept.
    std::vector<double> event_times{};
};

/// A move, with all that came of it: the next one can be played whatever becomes of the physics.
struct MoveRecord {
    static constexpr std::string_view kKind = "move";
    Seat seat;
    Move move;
    GameState state;                   ///< after it
    std::uint64_t state_hash = 0;      ///< of `state`
    std::optional<Ruling> ruling;      ///< where it ended a turn
    std::optional<ShotEvidence> shot;  ///< where it was one
    std::int64_t at_ms = 0;            ///< Unix time, ms
};

/// Version 1: a game begins, its first shot by `first`.
struct GameRecord {
    static constexpr std::string_view kKind = "game";
    std::uint32_t game_number = 1;
    Seat first;
};

/// Version 1: a shot, complete: `scene` has its strike, so that it can be simulated again by
/// itself.
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
    std::int64_t at_ms = 0;             ///< Unix time, ms
    std::vector<double> event_times{};  ///< as in ShotEvidence
};

/// The match was closed; nothing follows.
struct EndRecord {
    static constexpr std::string_view kKind = "end";
    std::string reason;
    std::int64_t at_ms = 0;
};

using ReplayRecord =
    std::variant<MatchRecord, SeatRecord, MoveRecord, EndRecord, GameRecord, ShotRecord>;

/// A record and its place in the match: 1, 2, 3, ... without a gap.
struct NumberedRecord {
    std::uint64_t n = 0;
    ReplayRecord record;
};

/// The record's kKind.
[[nodiscard]] std::string_view kind_of(const ReplayRecord& record);

/// The record of a step of a match.
[[nodiscard]] MoveRecord move_record(const MatchStep& step);

}  // namespace poolhall::protocol
