#pragma once

#include "protocol/wire/codecs.hpp"
#include "protocol/wire/game_fields.hpp"
#include "protocol/wire/scene_fields.hpp"
#include "protocol/wire/settings_fields.hpp"
#include "protocol/wire/shot_fields.hpp"

#include <tuple>

// The fields of every message, beside "type" and, for a client's, "seq".
namespace poolhall::protocol::wire {

inline constexpr std::size_t kMaxLabelBytes = 64;  ///< of ids and versions
inline constexpr std::size_t kMaxFrameEvents = 10000;
inline constexpr Integer kSeq{1};

// ---- client to server ------------------------------------------------------------

template <>
inline constexpr auto kFields<CreateMatch> = std::tuple{
    field("name", &CreateMatch::name, PersonName{}),
    field("game", &CreateMatch::game, Text{1, kMaxGameBytes}).or_default(),
    field("stream", &CreateMatch::stream).or_default(),
    field("settings", &CreateMatch::settings),
};

template <>
inline constexpr auto kFields<JoinMatch> = std::tuple{
    field("code", &JoinMatch::code, JoinCode{}),
    field("name", &JoinMatch::name, PersonName{}),
    field("stream", &JoinMatch::stream).or_default(),
};

template <>
inline constexpr auto kFields<WatchMatch> = std::tuple{
    field("code", &WatchMatch::code, JoinCode{}),
    field("name", &WatchMatch::name, PersonName{.may_be_empty = true}),
    field("stream", &WatchMatch::stream).or_default(),
};

template <>
inline constexpr auto kFields<Resume> = std::tuple{
    field("code", &Resume::code, JoinCode{}),
    field("token", &Resume::token, Token{}),
    field("stream", &Resume::stream).or_default(),
};

template <>
inline constexpr auto kFields<TakeSeat> = std::tuple{field("seat", &TakeSeat::seat)};

template <>
inline constexpr auto kFields<LeaveSeat> = std::tuple{field("seat", &LeaveSeat::seat)};

template <>
inline constexpr auto kFields<MakeMove> = std::tuple{
    field("seat", &MakeMove::seat),
    field("move", &MakeMove::move, Tagged{}),
};

template <>
inline constexpr auto kFields<Aim> = std::tuple{
    field("seat", &Aim::seat),
    field("direction", &Aim::direction, Direction{}),
    field("cue", &Aim::cue, Vector2{}),
};

template <>
inline constexpr auto kFields<Leave> = std::tuple{};

template <>
inline constexpr auto kFields<Ping> = std::tuple{};

// ---- server to client ------------------------------------------------------------

template <>
inline constexpr auto kFields<SeatInfo> = std::tuple{
    field("taken", &SeatInfo::taken),
    field("connected", &SeatInfo::connected),
    field("name", &SeatInfo::name, PersonName{.may_be_empty = true}),
    field("wants_rematch", &SeatInfo::wants_rematch),
    field("wins", &SeatInfo::wins),
};

template <>
inline constexpr auto kFields<LiveShot> = std::tuple{
    field("shot", &LiveShot::shot),
    field("tick", &LiveShot::tick),
    field("balls", &LiveShot::balls, List<Vector2>{{}, kMaxBalls}),
};

template <>
inline constexpr auto kFields<TableState> = std::tuple{
    field("match", &TableState::match, Text{1, kMaxLabelBytes}),
    field("code", &TableState::code, JoinCode{}),
    field("game", &TableState::game, Text{1, kMaxGameBytes}),
    field("settings", &TableState::settings),
    field("phase", &TableState::phase),
    field("game_number", &TableState::game_number),
    field("shot", &TableState::shot),
    field("seats", &TableState::seats, Array<Object<SeatInfo>>{}),
    field("spectators", &TableState::spectators),
    field("state", &TableState::state, GameStateCodec{}),
    field("legal", &TableState::legal, LegalCodec{}),
    field("aim", &TableState::aim, Vector2{kMaxDirectionComponent}),
    field("cue", &TableState::cue, Vector2{}),
    field("ruling", &TableState::ruling),
    field("winner", &TableState::winner),
    field("clock_left_ms", &TableState::clock_left_ms),
    field("live", &TableState::live),
};

/// A table whose parts agree with one another.
struct TableCodec {
    [[nodiscard]] bool read(const Cursor& cursor, TableState& table) const;

    [[nodiscard]] Json write(const TableState& table, Encoding encoding) const {
        return Object<TableState>{}.write(table, encoding);
    }
};

template <>
inline constexpr auto kFields<Welcome> = std::tuple{
    field("server", &Welcome::server, Text{1, kMaxLabelBytes}),
    field("protocol", &Welcome::protocol, Integer{1, 1000}),
};

template <>
inline constexpr auto kFields<Accepted> = std::tuple{field("seq", &Accepted::seq, kSeq)};

template <>
inline constexpr auto kFields<Reject> = std::tuple{
    field("seq", &Reject::seq),
    field("code", &Reject::code),
    field("reason", &Reject::reason, Text{0, kMaxReasonBytes}),
};

template <>
inline constexpr auto kFields<Joined> = std::tuple{
    field("seq", &Joined::seq, kSeq),
    field("token", &Joined::token, Token{.may_be_empty = true}),
    field("seats", &Joined::seats, List<SeatNumber>{{}, kSeatCount}),
    field("table", &Joined::table, TableCodec{}),
};

template <>
inline constexpr auto kFields<TableChanged> =
    std::tuple{field("table", &TableChanged::table, TableCodec{})};

template <>
inline constexpr auto kFields<AimChanged> = std::tuple{
    field("seat", &AimChanged::seat),
    field("direction", &AimChanged::direction, Direction{}),
    field("cue", &AimChanged::cue, Vector2{}),
};

template <>
inline constexpr auto kFields<ShotStarted> = std::tuple{
    field("shot", &ShotStarted::shot),
    field("seat", &ShotStarted::seat),
    field("scene", &ShotStarted::scene, SceneCodec{.strike_required = true}),
    field("scene_hash", &ShotStarted::scene_hash, Hash{}),
    field("final_hash", &ShotStarted::final_hash, Hash{}),
};

template <>
inline constexpr auto kFields<Frame> = std::tuple{
    field("shot", &Frame::shot),
    field("tick", &Frame::tick),
    field("balls", &Frame::balls, List<FrameBallCodec>{{}, kMaxBalls}),
    field("events", &Frame::events, List<EventCodec>{{}, kMaxFrameEvents}),
};

template <>
inline constexpr auto kFields<ShotEnded> = std::tuple{
    field("shot", &ShotEnded::shot),
    field("ticks", &ShotEnded::ticks),
    field("duration", &ShotEnded::duration, Number{0, kAnyMagnitude}),
    field("outcome", &ShotEnded::outcome),
    field("kernel", &ShotEnded::kernel, Text{1, kMaxLabelBytes}),
    field("effects", &ShotEnded::effects, kEffectUses),
    field("solver", &ShotEnded::solver),
    field("cpu_us", &ShotEnded::cpu_us, Number{0, kAnyMagnitude}),
    field("balls", &ShotEnded::balls, List<FinalBallCodec>{{}, kMaxBalls}),
    field("hash", &ShotEnded::hash, Hash{}),
    field("ruling", &ShotEnded::ruling),
    field("table", &ShotEnded::table, TableCodec{}),
};

template <>
inline constexpr auto kFields<Pong> = std::tuple{field("seq", &Pong::seq, kSeq)};

template <>
inline constexpr auto kFields<Closing> =
    std::tuple{field("reason", &Closing::reason, Text{0, kMaxReasonBytes})};

}  // namespace poolhall::protocol::wire
