#include "server/room/match.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <string_view>
#include <utility>

namespace poolhall::server {

using protocol::Phase;
using Microseconds = std::chrono::duration<double, std::micro>;

Match::Match(MatchSpec spec) : spec_(std::move(spec)) {
    begin_game(spec_.first);
}

void Match::begin_game(Seat first) {
    first_ = first;
    game_ = new_game(rules(), first, settings());
    aim_ = rules().default_aim(game_);
    rematch_ = {};
    ruling_.reset();
}

// ---- people

std::optional<Seat> Match::open_seat() const {
    for (const Seat seat : kSeats)
        if (!holder(seat)) return seat;
    return std::nullopt;
}

const std::optional<SeatHolder>& Match::holder(Seat seat) const {
    return seats_[seat.value];
}

bool Match::holds(MemberId member, Seat seat) const {
    return holder(seat) && holder(seat)->member == member;
}

std::vector<Seat> Match::seats_of(MemberId member) const {
    std::vector<Seat> seats;
    for (const Seat seat : kSeats)
        if (holds(member, seat)) seats.push_back(seat);
    return seats;
}

std::vector<Seat> Match::seats_of(const TokenHash& token) const {
    std::vector<Seat> seats;
    for (const Seat seat : kSeats)
        if (holder(seat) && same_token(holder(seat)->token, token)) seats.push_back(seat);
    return seats;
}

std::uint32_t Match::spectators() const {
    return static_cast<std::uint32_t>(spectators_.size());
}

std::string Match::spectator_name(MemberId member) const {
    const auto found = spectators_.find(member);
    return found == spectators_.end() ? std::string() : found->second;
}

bool Match::deserted() const {
    return std::none_of(seats_.begin(), seats_.end(),
                        [](const auto& seat) { return seat.has_value(); });
}

void Match::take_seat(Seat seat, SeatHolder holder) {
    assert(!seat_at(seat));
    if (holder.member) spectators_.erase(*holder.member);
    seat_at(seat) = std::move(holder);
    wins_[seat.value] = 0;
    rematch_[seat.value] = false;
}

void Match::leave_seat(Seat seat) {
    assert(!playout_);
    const std::optional<SeatHolder> left = std::exchange(seat_at(seat), std::nullopt);
    wins_[seat.value] = 0;
    rematch_[seat.value] = false;
    if (left && left->member && seats_of(*left->member).empty()) watch(*left->member, left->name);
}

void Match::watch(MemberId member, std::string name) {
    spectators_[member] = std::move(name);
}

void Match::leave(MemberId member) {
    for (const Seat seat : seats_of(member))
        leave_seat(seat);
    spectators_.erase(member);
}

void Match::disconnect(MemberId member) {
    for (const Seat seat : seats_of(member))
        seat_at(seat)->member.reset();
    spectators_.erase(member);
}

std::optional<MemberId> Match::resume(const TokenHash& token, MemberId member) {
    std::optional<MemberId> replaced;
    for (const Seat seat : seats_of(token)) {
        if (seat_at(seat)->member) replaced = seat_at(seat)->member;
        seat_at(seat)->member = member;
    }
    return replaced;
}

// ---- the game

Phase Match::phase() const {
    if (playout_) return Phase::kPlaying;
    if (game_.over) return Phase::kOver;
    return open_seat() ? Phase::kWaiting : Phase::kAiming;
}

Vec2 Match::cue_ball() const {
    return xy(game_.scene.balls[game_.cue_ball.value].state.r);
}

protocol::SeatInfo Match::seat_info(Seat seat) const {
    protocol::SeatInfo info;
    info.wins = wins_[seat.value];
    info.wants_rematch = rematch_[seat.value];
    if (const auto& held = holder(seat)) {
        info.taken = true;
        info.connected = held->member.has_value();
        info.name = held->name;
    }
    return info;
}

protocol::TableState Match::table() const {
    protocol::TableState table;
    table.match = spec_.id;
    table.code = spec_.code;
    table.game = rules().name;
    table.phase = phase();
    table.game_number = game_number_;
    table.shot = shots_;
    table.turn = game_.turn;
    table.may_place =
        !playout_ && !game_.over && rules().nearest_placement(game_, cue_ball()).has_value();
    for (const Seat seat : kSeats)
        table.seats[seat.value] = seat_info(seat);
    table.spectators = spectators();
    table.aim = aim_;
    table.scene = game_.scene;
    table.cue_ball = game_.cue_ball;
    table.ruling = ruling_;
    if (playout_) table.live = playout_->live();
    return table;
}

void Match::place_cue_ball(Vec2 position) {
    [[maybe_unused]] const auto refused = rules().place_cue_ball(game_, position);
    assert(!refused);
    aim_ = rules().default_aim(game_);
}

void Match::start_shot(ShotOutcome outcome, std::chrono::nanoseconds cpu) {
    assert(!playout_);
    ++shots_;
    playout_.emplace(shots_, std::move(outcome), cpu);
}

protocol::ShotEnded Match::finish_shot() {
    assert(playout_);
    const Playout playout = *std::exchange(playout_, std::nullopt);
    const ShotOutcome& outcome = playout.outcome();
    game_ = outcome.state;
    ruling_ = outcome.ruling;
    if (game_.winner) ++wins_[game_.winner->value];
    if (!game_.over) aim_ = rules().default_aim(game_);

    const ShotTrace& trace = outcome.trace;
    return {playout.shot(),
            playout.last_tick(),
            trace.duration,
            trace.outcome,
            std::string(trace.kernel),
            trace.solver,
            Microseconds(playout.cpu()).count(),
            trace.balls,
            trace.hash,
            outcome.ruling,
            table()};
}

void Match::start_next_game() {
    ++game_number_;
    begin_game(next_first());
}

}  // namespace poolhall::server
