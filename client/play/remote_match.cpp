#include "client/play/remote_match.hpp"

#include "client/play/isolated.hpp"
#include "protocol/limits.hpp"

#include <algorithm>
#include <utility>

namespace poolhall::client {
namespace {

using protocol::ClientBody;
using protocol::Phase;
using protocol::RejectCode;
using protocol::TableState;

constexpr std::size_t kMaxUnanswered = 64;

template <class T>
bool is(const ClientBody& body) {
    return std::holds_alternative<T>(body);
}

/// An aim that crosses the end of a turn on its way is nobody's mistake.
bool is_worth_a_word(const protocol::Reject& reject, const std::optional<ClientBody>& command) {
    const bool late =
        reject.code == RejectCode::kNotYourTurn || reject.code == RejectCode::kWrongPhase;
    const bool move =
        command && (is<protocol::Aim>(*command) || is<protocol::PlaceCueBall>(*command));
    return !(late && move);
}

bool is_passing(RejectCode code) {
    return code == RejectCode::kServerFull || code == RejectCode::kShuttingDown ||
           code == RejectCode::kStorage;
}

}  // namespace

RemoteMatch::RemoteMatch(Wish wish, Transport& transport, TokenStore& tokens, Playback& playback)
    : entrance_(std::move(wish), tokens), transport_(transport), playback_(playback) {
    info_.link = Link::kConnecting;
}

void RemoteMatch::poll(double now) {
    now_ = now;
    while (auto event = transport_.next()) {
        std::visit([this](const auto& e) { on(e); }, *event);
        ++info_.revision;
    }
    if (info_.link != Link::kOnline) return;
    if (now_ - moved_at_ >= kMoveEvery) send_moves();
    ping_if_due();
}

double RemoteMatch::due_in(double now) const {
    if (info_.link != Link::kOnline) return kPingEvery;
    const bool moves = unsent_aim_ || unsent_place_;
    const double due = moves ? moved_at_ + kMoveEvery : pinged_at_ + kPingEvery;
    return std::max(0.0, due - now);
}

std::string RemoteMatch::take_notice() {
    return std::exchange(notice_, {});
}

// ---- commands
// -----------------------------------------------------------------------------------------------

void RemoteMatch::aim(Vec2 direction) {
    if (!info_.acting_seat()) return;
    unsent_aim_ = direction;
    info_.table->aim = direction;
    ++info_.revision;
}

void RemoteMatch::place_cue_ball(Vec2 position) {
    if (!info_.acting_seat() || !info_.table->may_place) return;
    unsent_place_ = position;
    set_cue_ball(position);
    // The server points the aim anew in the same way.
    if (const Ruleset* rules = find_ruleset(info_.table->game)) {
        info_.table->aim = rules->default_aim(game_state_of(*info_.table));
    }
    unsent_aim_.reset();
    ++info_.revision;
}

void RemoteMatch::shoot(Vec2 direction) {
    const auto seat = info_.acting_seat();
    if (!seat || info_.link != Link::kOnline) return;
    send_moves();
    command(protocol::Shoot{*seat, direction});
}

void RemoteMatch::ask_new_game() {
    if (!info_.table || info_.table->phase != Phase::kOver || info_.link != Link::kOnline) return;
    for (std::uint8_t i = 0; i < kSeatCount; ++i) {
        if (info_.mine[i] && !info_.table->seats[i].wants_rematch)
            command(protocol::Rematch{Seat{i}});
    }
}

void RemoteMatch::toggle_hot_seat() {
    if (!info_.table || info_.link != Link::kOnline) return;
    if (!info_.seated()) {
        notice_ = "Spectators have no seat to share";
        return;
    }
    if (info_.hot_seat()) {
        command(protocol::LeaveSeat{second_seat_});
        return;
    }
    const Seat other{static_cast<std::uint8_t>(info_.mine[0] ? 1 : 0)};
    if (info_.table->seats[other.value].taken) {
        notice_ = "The other seat is taken";
        return;
    }
    command(protocol::TakeSeat{other});
}

void RemoteMatch::retry_now() {
    transport_.retry_now();
}

// ---- what the transport says
// ----------------------------------------------------------------------------------

void RemoteMatch::on(const Opened& /*event*/) {
    info_.link = Link::kConnecting;
    seq_ = 0;
    entry_seq_ = 0;
    unanswered_.clear();
    closing_reason_.clear();
}

void RemoteMatch::on(const Lost& event) {
    info_.link = info_.table ? Link::kLost : Link::kConnecting;
    info_.round_trip_ms.reset();
    info_.trouble = closing_reason_.empty() ? event.reason : closing_reason_;
    unsent_aim_.reset();
    unsent_place_.reset();
    unanswered_.clear();
}

void RemoteMatch::on(const Received& event) {
    received_at_ = event.at;
    std::visit([this](const auto& message) { on(message); }, event.message);
}

void RemoteMatch::on(const protocol::Welcome& message) {
    if (message.protocol == protocol::kVersion) {
        enter(entrance_.request());
        return;
    }
    info_.trouble = "The server speaks protocol " + std::to_string(message.protocol) +
                    ", this client " + std::to_string(protocol::kVersion);
}

void RemoteMatch::on(const protocol::Accepted& message) {
    const auto command = take_command(message.seq);
    if (!command) return;
    if (const auto* take = std::get_if<protocol::TakeSeat>(&*command)) {
        second_seat_ = take->seat;
        info_.mine[take->seat.value] = true;
    }
    if (const auto* leave = std::get_if<protocol::LeaveSeat>(&*command))
        info_.mine[leave->seat.value] = false;
    if (const auto* place = std::get_if<protocol::PlaceCueBall>(&*command))
        confirmed_cue_ = place->position;
}

void RemoteMatch::on(const protocol::Reject& message) {
    if (message.seq != 0 && message.seq == entry_seq_) {
        entry_refused(message);
        return;
    }
    const auto command = take_command(message.seq);
    if (command && is<protocol::PlaceCueBall>(*command) && !placing()) set_cue_ball(confirmed_cue_);
    if (is_worth_a_word(message, command)) notice_ = message.reason;
}

void RemoteMatch::on(const protocol::Joined& message) {
    entry_seq_ = 0;
    entrance_.entered(message);
    info_.link = Link::kOnline;
    info_.trouble.clear();
    info_.mine = {};
    for (const Seat seat : message.seats) {
        if (seat.value < kSeatCount) info_.mine[seat.value] = true;
    }
    resume_playback(message.table);
    show_table(message.table);
    // A server that was started again has forgotten the aim; whoever aims has not.
    if (info_.acting_seat() && info_.table->aim != message.table.aim)
        unsent_aim_ = info_.table->aim;
    pinged_at_ = now_ - kPingEvery;
}

void RemoteMatch::on(const protocol::TableChanged& message) {
    show_table(message.table);
}

void RemoteMatch::on(const protocol::AimChanged& message) {
    if (!info_.table || message.seat.value >= kSeatCount || info_.mine[message.seat.value]) return;
    info_.table->aim = message.direction;
    confirmed_cue_ = message.cue;
    set_cue_ball(message.cue);
}

void RemoteMatch::on(const protocol::ShotStarted& message) {
    if (!info_.table) return;
    unsent_aim_.reset();
    unsent_place_.reset();
    info_.table->phase = Phase::kPlaying;
    info_.table->shot = message.shot;
    ShotTimeline timeline(positions_of(message.scene));
    playback_.begin(
        {message.shot, message.scene, info_.table->cue_ball, std::move(timeline), std::nullopt});
}

void RemoteMatch::on(const protocol::Frame& message) {
    Shot* shot = playback_.newest();
    if (shot == nullptr || shot->number != message.shot) return;
    std::vector<ShotTimeline::Moved> moved;
    moved.reserve(message.balls.size());
    for (const auto& ball : message.balls)
        moved.push_back({ball.ball, ball.r});
    shot->timeline.extend(message.tick * Playback::kStep, message.events, moved);
}

void RemoteMatch::on(const protocol::ShotEnded& message) {
    info_.kernel = message.kernel;
    Shot* shot = playback_.newest();
    if (shot != nullptr && shot->number == message.shot) {
        shot->timeline.finish(message.duration, message.balls);
        shot->ruling = message.ruling;
        // A shot that cannot be finished would be waited for without end.
        if (!shot->timeline.complete()) playback_.clear();
    }
    show_table(message.table);
}

void RemoteMatch::on(const protocol::Pong& message) {
    if (message.seq != ping_seq_ || ping_seq_ == 0) return;
    info_.round_trip_ms = 1000 * std::max(0.0, received_at_ - pinged_at_);
}

void RemoteMatch::on(const protocol::Closing& message) {
    closing_reason_ = message.reason;
}

// ---- sending
// --------------------------------------------------------------------------------------------------

std::uint32_t RemoteMatch::send(ClientBody body) {
    transport_.send({++seq_, std::move(body)});
    return seq_;
}

void RemoteMatch::command(ClientBody body) {
    const std::uint32_t seq = send(body);
    unanswered_.push_back({seq, std::move(body)});
    if (unanswered_.size() > kMaxUnanswered) unanswered_.pop_front();
}

std::optional<ClientBody> RemoteMatch::take_command(std::uint32_t seq) {
    const auto found = std::find_if(unanswered_.begin(), unanswered_.end(),
                                    [seq](const Command& c) { return c.seq == seq; });
    if (found == unanswered_.end()) return std::nullopt;
    ClientBody body = std::move(found->body);
    unanswered_.erase(found);
    return body;
}

void RemoteMatch::enter(ClientBody request) {
    entry_seq_ = send(std::move(request));
}

void RemoteMatch::entry_refused(const protocol::Reject& reject) {
    entry_seq_ = 0;
    if (auto other_way = entrance_.request_after(reject.code)) {
        enter(std::move(*other_way));
        return;
    }
    info_.trouble = reject.reason;
    if (is_passing(reject.code)) transport_.drop(reject.reason);
}

void RemoteMatch::send_moves() {
    const auto seat = info_.acting_seat();
    const auto place = std::exchange(unsent_place_, std::nullopt);
    const auto direction = std::exchange(unsent_aim_, std::nullopt);
    if (!seat || (!place && !direction)) return;
    if (place) command(protocol::PlaceCueBall{*seat, *place});
    if (direction) command(protocol::Aim{*seat, *direction});
    moved_at_ = now_;
}

void RemoteMatch::ping_if_due() {
    if (now_ - pinged_at_ < kPingEvery) return;
    ping_seq_ = send(protocol::Ping{});
    pinged_at_ = now_;
}

// ---- state
// ------------------------------------------------------------------------------------------------------

void RemoteMatch::show_table(const TableState& table) {
    if (table.cue_ball.value >= table.scene.balls.size() || table.turn.value >= kSeatCount) return;
    const bool my_aim_stands = info_.acting_seat() && info_.table->shot == table.shot &&
                               info_.table->game_number == table.game_number &&
                               info_.table->turn == table.turn;
    const auto before = std::exchange(info_.table, table);
    confirmed_cue_ = xy(table.scene.balls[table.cue_ball.value].state.r);
    if (before && my_aim_stands) {
        info_.table->aim = before->aim;
        if (placing()) set_cue_ball(xy(before->scene.balls[before->cue_ball.value].state.r));
    }
    if (before) note_changes(*before);
}

void RemoteMatch::note_changes(const TableState& before) {
    for (std::size_t i = 0; i < kSeatCount; ++i) {
        const auto& was = before.seats[i];
        const auto& is_now = info_.table->seats[i];
        if (info_.mine[i]) continue;
        if (!was.taken && is_now.taken) notice_ = isolated(is_now.name) + " sits down";
        if (was.taken && !is_now.taken) notice_ = isolated(was.name) + " has left";
        if (!was.taken || !is_now.taken) continue;
        if (was.connected && !is_now.connected)
            notice_ = isolated(is_now.name) + " has lost the connection";
        if (!was.connected && is_now.connected) notice_ = isolated(is_now.name) + " is back";
    }
}

void RemoteMatch::resume_playback(const TableState& table) {
    const Shot* shot = playback_.newest();
    if (table.live || (shot != nullptr && !shot->timeline.complete())) playback_.clear();
    if (!table.live || table.live->balls.size() != table.scene.balls.size()) return;
    ShotTimeline timeline(table.live->balls, table.live->tick * Playback::kStep);
    playback_.begin(
        {table.live->shot, table.scene, table.cue_ball, std::move(timeline), std::nullopt});
}

bool RemoteMatch::placing() const {
    return unsent_place_ ||
           std::any_of(unanswered_.begin(), unanswered_.end(),
                       [](const Command& c) { return is<protocol::PlaceCueBall>(c.body); });
}

void RemoteMatch::set_cue_ball(Vec2 position) {
    if (info_.table)
        set_xy(info_.table->scene.balls[info_.table->cue_ball.value].state.r, position);
}

std::string shown_code(const std::string& code) {
    const std::size_t half = protocol::kCodeLetters / 2;
    return code.size() == protocol::kCodeLetters ? code.substr(0, half) + "-" + code.substr(half)
                                                 : code;
}

}  // namespace poolhall::client
