#include "server/room/table.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace poolhall::server {

using protocol::Phase;

Table::Table(std::string match_id, std::string join_code, const MatchSpec& spec)
    : id(std::move(match_id)),
      code(std::move(join_code)),
      match(spec),
      aim{match.now().legal.aim, {}} {}

void Table::commit(MatchStep step, std::int64_t now_ms) {
    match.commit(std::move(step), now_ms);
    aim = {match.now().legal.aim, {}};
}

void Table::take_seat(Seat seat, SeatHolder holder) {
    roster.take_seat(seat, std::move(holder));
    match.reset_seat(seat);
}

void Table::leave_seat(Seat seat) {
    assert(!playout);
    roster.leave_seat(seat);
    match.reset_seat(seat);
}

void Table::leave(MemberId member) {
    for (const Seat seat : roster.leave(member))
        match.reset_seat(seat);
}

Phase phase_of(const Table& table) {
    if (table.playout) return Phase::kPlaying;
    if (table.match.now().game.over) return Phase::kOver;
    return table.roster.open_seat() ? Phase::kWaiting : Phase::kAiming;
}

bool clock_runs(const Table& table) {
    return table.match.settings().shot_clock_s && phase_of(table) == Phase::kAiming &&
           table.roster.attended();
}

Vec2 shown_cue_ball(const Table& table) {
    const GameState& game = table.match.now().game;
    return table.aim.cue.value_or(xy(game.scene.balls[game.cue_ball.value].state.r));
}

namespace {

protocol::SeatInfo seat_info(const Table& table, Seat seat) {
    protocol::SeatInfo info;
    info.wins = table.match.now().wins[seat.value];
    info.wants_rematch = table.match.now().consents[seat.value];
    if (const auto& held = table.roster.holder(seat)) {
        info.taken = true;
        info.connected = held->member.has_value();
        info.name = held->name;
    }
    return info;
}

/// ms; nothing where no clock runs.
std::optional<std::uint32_t> clock_left(const Table& table, std::int64_t now_ms) {
    const auto ends = table.match.clock_ends_ms();
    if (!ends || !clock_runs(table)) return std::nullopt;
    constexpr std::int64_t kMost = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(*ends - now_ms, 0, kMost));
}

}  // namespace

protocol::TableState state_of(const Table& table, std::int64_t now_ms) {
    const Position& now = table.match.now();
    protocol::TableState state;
    state.match = table.id;
    state.code = table.code;
    state.game = table.match.rules().name;
    if (table.match.settings() != MatchSettings{}) state.settings = table.match.settings();
    state.phase = phase_of(table);
    state.game_number = now.game_number;
    // The running shot counts as taken.
    state.shot = table.playout ? table.playout->shot().shot : now.shots;
    for (const Seat seat : kSeats)
        state.seats[seat.value] = seat_info(table, seat);
    state.spectators = table.roster.spectators();
    state.state = now.game;
    state.legal = now.legal;
    state.aim = table.aim.direction;
    state.cue = table.aim.cue;
    state.ruling = now.ruling;
    state.winner = now.winner;
    state.clock_left_ms = clock_left(table, now_ms);
    if (table.playout) state.live = table.playout->live();
    return state;
}

}  // namespace poolhall::server
