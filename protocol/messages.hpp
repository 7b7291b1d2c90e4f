#pragma once

#include "shared/analysis/effect_use.hpp"
#include "shared/enum_names.hpp"
#include "shared/game/game_state.hpp"
#include "shared/game/legal.hpp"
#include "shared/game/move.hpp"
#include "shared/match/settings.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// The messages of PROTOCOL.md, one struct each; kType is their "type". The two variants at the end
// are the list of messages that encoding, dispatch and the documents follow.
namespace poolhall::protocol {

/// How a client hears of shots.
enum class Stream : std::uint8_t {
    kStates,  ///< a frame at each 30 Hz tick
    kShots,   ///< the shot and its final hash; the client simulates it itself
};

constexpr auto enum_names(Stream /*type*/) {
    return names_of<Stream>({{Stream::kStates, "states"}, {Stream::kShots, "shots"}});
}

// ---- client to server ------------------------------------------------------------

struct CreateMatch {
    static constexpr std::string_view kType = "create_match";
    std::string name;
    std::string game = "end_game";
    Stream stream = Stream::kStates;
    std::optional<MatchSettings> settings{};  ///< absent or empty: the game's own

    friend bool operator==(const CreateMatch&, const CreateMatch&) = default;
};

struct JoinMatch {
    static constexpr std::string_view kType = "join_match";
    std::string code;
    std::string name;
    Stream stream = Stream::kStates;

    friend bool operator==(const JoinMatch&, const JoinMatch&) = default;
};

struct WatchMatch {
    static constexpr std::string_view kType = "watch_match";
    std::string code;
    std::string name;
    Stream stream = Stream::kStates;

    friend bool operator==(const WatchMatch&, const WatchMatch&) = default;
};

/// Comes back to the seats that the token holds.
struct Resume {
    static constexpr std::string_view kType = "resume";
    std::string code;
    std::string token;
    Stream stream = Stream::kStates;

    friend bool operator==(const Resume&, const Resume&) = default;
};

/// A seated player also takes the open seat: one person plays both ("hot seat").
struct TakeSeat {
    static constexpr std::string_view kType = "take_seat";
    Seat seat;

    friend bool operator==(const TakeSeat&, const TakeSeat&) = default;
};

/// Gives a seat back, so that somebody else can join. Not while a shot runs.
struct LeaveSeat {
    static constexpr std::string_view kType = "leave_seat";
    Seat seat;

    friend bool operator==(const LeaveSeat&, const LeaveSeat&) = default;
};

/// Plays a move of the game.
struct MakeMove {
    static constexpr std::string_view kType = "move";
    Seat seat;
    Move move;

    friend bool operator==(const MakeMove&, const MakeMove&) = default;
};

/// What a player is about to do, for the others to see. It decides nothing.
struct Aim {
    static constexpr std::string_view kType = "aim";
    Seat seat;
    Vec2 direction;
    std::optional<Vec2> cue{};  ///< where the cue ball in hand is held, m

    friend bool operator==(const Aim&, const Aim&) = default;
};

/// Leaves the match: seats become open, the session can create or join another.
struct Leave {
    static constexpr std::string_view kType = "leave";

    friend bool operator==(const Leave&, const Leave&) = default;
};

struct Ping {
    static constexpr std::string_view kType = "ping";

    friend bool operator==(const Ping&, const Ping&) = default;
};

// By who answers them: the lobby, or the match about its seats, its game, its talk; the session
// itself answers a ping.
using EntryCommand = std::variant<CreateMatch, JoinMatch, WatchMatch, Resume>;
using SeatCommand = std::variant<TakeSeat, LeaveSeat, Leave>;
using TurnCommand = std::variant<MakeMove>;
using TableTalk = std::variant<Aim>;

using ClientBody = std::variant<EntryCommand, SeatCommand, TurnCommand, TableTalk, Ping>;

struct ClientMessage {
    std::uint32_t seq = 0;  ///< 1 or more, rising within a connection
    ClientBody body;

    friend bool operator==(const ClientMessage&, const ClientMessage&) = default;
};

// ---- server to client ------------------------------------------------------------

enum class RejectCode : std::uint8_t {
    kMalformed,  ///< not the encoding, or not an object
    kUnknownType,
    kMissingField,
    kUnknownField,
    kBadField,  ///< wrong type, not finite, out of range
    kStaleSeq,  ///< seq not above the last one
    kNotInMatch,
    kAlreadyInMatch,
    kUnknownMatch,  ///< no match has this code
    kUnknownGame,
    kBadToken,
    kMatchFull,  ///< both seats taken
    kSpectatorsFull,
    kNotYourSeat,  ///< the session does not hold the seat
    kSeatTaken,
    kNotYourTurn,
    kWrongPhase,  ///< the match is waiting, playing out a shot, or over
    kIllegal,     ///< the rules refuse it (no such move now, out of bounds)
    kServerFull,  ///< no more matches
    kShuttingDown,
    kStorage,  ///< the shot could not be made durable; nothing happened
};

constexpr auto enum_names(RejectCode /*type*/) {
    return names_of<RejectCode>({{RejectCode::kMalformed, "malformed"},
                                 {RejectCode::kUnknownType, "unknown_type"},
                                 {RejectCode::kMissingField, "missing_field"},
                                 {RejectCode::kUnknownField, "unknown_field"},
                                 {RejectCode::kBadField, "bad_field"},
                                 {RejectCode::kStaleSeq, "stale_seq"},
                                 {RejectCode::kNotInMatch, "not_in_match"},
                                 {RejectCode::kAlreadyInMatch, "already_in_match"},
                                 {RejectCode::kUnknownMatch, "unknown_match"},
                                 {RejectCode::kUnknownGame, "unknown_game"},
                                 {RejectCode::kBadToken, "bad_token"},
                                 {RejectCode::kMatchFull, "match_full"},
                                 {RejectCode::kSpectatorsFull, "spectators_full"},
                                 {RejectCode::kNotYourSeat, "not_your_seat"},
                                 {RejectCode::kSeatTaken, "seat_taken"},
                                 {RejectCode::kNotYourTurn, "not_your_turn"},
                                 {RejectCode::kWrongPhase, "wrong_phase"},
                                 {RejectCode::kIllegal, "illegal"},
                                 {RejectCode::kServerFull, "server_full"},
                                 {RejectCode::kShuttingDown, "shutting_down"},
                                 {RejectCode::kStorage, "storage"}});
}

enum class Phase : std::uint8_t {
    kWaiting,  ///< a seat is open
    kAiming,
    kPlaying,  ///< a shot runs
    kOver,     ///< the game is; rematch or leave
};

constexpr auto enum_names(Phase /*type*/) {
    return names_of<Phase>({{Phase::kWaiting, "waiting"},
                            {Phase::kAiming, "aiming"},
                            {Phase::kPlaying, "playing"},
                            {Phase::kOver, "over"}});
}

struct SeatInfo {
    bool taken = false;
    bool connected = false;
    std::string name;
    bool wants_rematch = false;
    std::uint32_t wins = 0;

    friend bool operator==(const SeatInfo&, const SeatInfo&) = default;
};

/// Where a shot in progress stands, for those who come late.
struct LiveShot {
    std::uint32_t shot = 0;
    std::uint32_t tick = 0;
    std::vector<Vec2> balls;  ///< at that tick, in the scene's order, m

    friend bool operator==(const LiveShot&, const LiveShot&) = default;
};

/// All that is public of a match between two messages.
struct TableState {
    std::string match;  ///< id, also of its replay
    std::string code;
    std::string game;                         ///< ruleset
    std::optional<MatchSettings> settings{};  ///< absent: the game's own
    Phase phase = Phase::kWaiting;
    std::uint32_t game_number = 1;
    std::uint32_t shot = 0;  ///< shots taken in the match
    std::array<SeatInfo, kSeatCount> seats;
    std::uint32_t spectators = 0;
    GameState state;                             ///< at rest: before the running shot, if one runs
    Legal legal;                                 ///< who may do what in that state
    Vec2 aim;                                    ///< the direction shown now
    std::optional<Vec2> cue{};                   ///< where the cue ball in hand is held, m
    std::optional<Ruling> ruling;                ///< of the last turn of this game
    std::optional<Seat> winner;                  ///< of the race, once it is over
    std::optional<std::uint32_t> clock_left_ms;  ///< of the turn, where a clock runs
    std::optional<LiveShot> live;                ///< while phase is kPlaying

    friend bool operator==(const TableState&, const TableState&) = default;
};

/// The first message of every session.
struct Welcome {
    static constexpr std::string_view kType = "welcome";
    std::string server;  ///< "poolhall 0.1.0"
    int protocol = 1;

    friend bool operator==(const Welcome&, const Welcome&) = default;
};

struct Accepted {
    static constexpr std::string_view kType = "accepted";
    std::uint32_t seq = 0;

    friend bool operator==(const Accepted&, const Accepted&) = default;
};

struct Reject {
    static constexpr std::string_view kType = "reject";
    std::uint32_t seq = 0;  ///< 0: it could not be read
    RejectCode code = RejectCode::kMalformed;
    std::string reason;  ///< a sentence

    friend bool operator==(const Reject&, const Reject&) = default;
};

/// Answers create_match, join_match, watch_match and resume.
struct Joined {
    static constexpr std::string_view kType = "joined";
    std::uint32_t seq = 0;
    std::string token;        ///< brings a player back to the seats; empty for a spectator
    std::vector<Seat> seats;  ///< held by this session
    TableState table;

    friend bool operator==(const Joined&, const Joined&) = default;
};

/// Whenever seats, phase, state or the number of spectators change.
struct TableChanged {
    static constexpr std::string_view kType = "table";
    TableState table;

    friend bool operator==(const TableChanged&, const TableChanged&) = default;
};

struct AimChanged {
    static constexpr std::string_view kType = "aim";
    Seat seat;
    Vec2 direction;
    Vec2 cue;  ///< where the cue ball is, m

    friend bool operator==(const AimChanged&, const AimChanged&) = default;
};

struct ShotStarted {
    static constexpr std::string_view kType = "shot_started";
    std::uint32_t shot = 0;  ///< from 1, within the match
    Seat seat;
    Scene scene;  ///< complete, with its strike
    std::uint64_t scene_hash = 0;
    std::optional<std::uint64_t> final_hash;  ///< for Stream::kShots

    friend bool operator==(const ShotStarted&, const ShotStarted&) = default;
};

/// The shot at tick / 30 s. Positions are for display, rounded to 10 um or to single precision.
struct Frame {
    static constexpr std::string_view kType = "frame";

    struct Ball {
        BallIndex ball;
        Vec2 r;  ///< m

        friend bool operator==(const Ball&, const Ball&) = default;
    };

    std::uint32_t shot = 0;
    std::uint32_t tick = 0;
    std::vector<Ball> balls;        ///< those that moved since the last tick
    std::vector<ShotEvent> events;  ///< since the last tick, with exact times and positions

    friend bool operator==(const Frame&, const Frame&) = default;
};

struct ShotEnded {
    static constexpr std::string_view kType = "shot_ended";
    std::uint32_t shot = 0;
    std::uint32_t ticks = 0;  ///< of the playout
    double duration = 0;      ///< s
    Outcome outcome = Outcome::kRest;
    std::string kernel;
    /// What the scene names, and what of it the shot called for.
    std::vector<analysis::EffectUse> effects;
    SolverKind solver = SolverKind::kEuler;
    double cpu_us = 0;             ///< what the server spent on simulating it, microseconds
    std::vector<FinalBall> balls;  ///< exact, in the order of the shot's scene
    std::uint64_t hash = 0;
    Ruling ruling;
    TableState table;  ///< what comes next

    friend bool operator==(const ShotEnded&, const ShotEnded&) = default;
};

struct Pong {
    static constexpr std::string_view kType = "pong";
    std::uint32_t seq = 0;

    friend bool operator==(const Pong&, const Pong&) = default;
};

/// The last message before the server closes the session.
struct Closing {
    static constexpr std::string_view kType = "closing";
    std::string reason;

    friend bool operator==(const Closing&, const Closing&) = default;
};

using ServerMessage = std::variant<Welcome, Accepted, Reject, Joined, TableChanged, AimChanged,
                                   ShotStarted, Frame, ShotEnded, Pong, Closing>;

}  // namespace poolhall::protocol
