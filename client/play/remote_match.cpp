#include "client/play/remote_match.hpp"

#include "client/play/cue_ball.hpp"
#include "client/play/isolated.hpp"
#include "client/play/words.hpp"
#include "protocol/limits.hpp"

#include <algorithm>
#include <utility>

namespace poolhall::client {
namespace {

using protocol::ClientBody;
using protocol::Phase;
using protocol::RejectCode;
using protocol::TableState;

/// The command, if it is a T of that group.
template <class T, class Group>
const T* as(const ClientBody& body) {
    const auto* group = std::get_if<Group>(&body);
    return group != nullptr ? std::get_if<T>(group) : nullptr;
}

bool is_aim(const ClientBody& body) {
    return as<protocol::Aim, protocol::TableTalk>(body) != nullptr;
}

template <class T>
bool is_move(const ClientBody& body) {
    const auto* made = as<protocol::MakeMove, protocol::TurnCommand>(body);
    return made != nullptr && std::holds_alternative<T>(made->move);
}

/// What crosses the end of a turn on its way, and is no shot, is nobody's mistake.
bool is_worth_a_word(const protocol::Reject& reject, const std::optional<ClientBody>& command) {
    const bool late =
        reject.code == RejectCode::kNotYourTurn || reject.code == RejectCode::kWrongPhase;
    return !(late && command && (is_aim(*command) || is_move<Place>(*command)));
}

bool is_passing(RejectCode code) {
    return code == RejectCode::kServerFull || code == RejectCode::kShuttingDown ||
           code == RejectCode::kStorage;
}

}  // namespace

RemoteMatch::RemoteMatch(EntryRequest wanted, Transport& transport, TokenKeeper& tokens,
                         Playback& playback)
    : entrance_(std::move(wanted), tokens), transport_(transport), playback_(playback) {
    info_.link = Link::kConnecting;
}

void RemoteMatch::poll(double now) {
    now_ = now;
    while (auto event = transport_.next()) {
        std::visit([this](const auto& e) { on(e); }, *event);
        ++info_.revision;
    }
    if (info_.link != Link::kOnline) return;
    if (aim_unsent_ && now_ - aim_sent_at_ >= kAimEvery) send_aim();
    ping_if_due();
}

double RemoteMatch::due_in(double now) const {
    if (info_.link != Link::kOnline) return kPingEvery;
    const double due = aim_unsent_ ? aim_sent_at_ + kAimEvery : pinged_at_ + kPingEvery;
    return std::max(0.0, due - now);
}

std::string RemoteMatch::take_notice() {
    return std::exchange(notice_, {});
}

// ---- commands

void RemoteMatch::aim(Vec2 direction) {
    if (!info_.acting_seat()) return;
    info_.table->aim = direction;
    aim_unsent_ = true;
    ++info_.revision;
}

void RemoteMatch::hold_cue_ball(Vec2 position) {
    if (!info_.acting_seat()) return;
    if (!client::hold_cue_ball(*info_.table, position)) return;
    aim_unsent_ = true;
    ++info_.revision;
}

void RemoteMatch::make(const Move& move) {
    if (info_.link != Link::kOnline) return;
    for (const Seat seat : movers(info_, move)) {
        if (std::holds_alternative<Shoot>(move)) {
            const auto held = unplaced_cue_ball(*info_.table);
            if (held) command(protocol::MakeMove{seat, Place{*held}});
            aim_unsent_ = false;  // the shot itself will show it
        }
        command(protocol::MakeMove{seat, move});
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

void RemoteMatch::on(const Opened& /*event*/) {
    info_.link = Link::kConnecting;
    sent_.restart();
    entry_seq_ = 0;
    closing_reason_.clear();
}

void RemoteMatch::on(const Lost& event) {
    info_.link = info_.table ? Link::kLost : Link::kConnecting;
    info_.round_trip_ms.reset();
    info_.clock_ends.reset();
    info_.trouble = closing_reason_.empty() ? event.reason : closing_reason_;
    aim_unsent_ = false;
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
    const auto command = sent_.take(message.seq);
    if (!command) return;
    if (const auto* take = as<protocol::TakeSeat, protocol::SeatCommand>(*command)) {
        second_seat_ = take->seat;
        info_.mine[take->seat.value] = true;
    }
    if (const auto* leave = as<protocol::LeaveSeat, protocol::SeatCommand>(*command))
        info_.mine[leave->seat.value] = false;
}

void RemoteMatch::on(const protocol::Reject& message) {
    if (message.seq != 0 && message.seq == entry_seq_) {
        entry_refused(message);
        return;
    }
    const auto command = sent_.take(message.seq);
    if (command && is_move<Place>(*command) && info_.table) info_.table->cue.reset();
    if (command && is_move<Shoot>(*command)) aim_unsent_ = info_.acting_seat().has_value();
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
    const bool forgotten = info_.table && (info_.table->aim != message.table.aim ||
                                           info_.table->cue != message.table.cue);
    aim_unsent_ = forgotten && info_.acting_seat();
    pinged_at_ = now_ - kPingEvery;
}

void RemoteMatch::on(const protocol::TableChanged& message) {
    show_table(message.table);
}

void RemoteMatch::on(const protocol::AimChanged& message) {
    if (!info_.table || message.seat.value >= kSeatCount || info_.mine[message.seat.value]) return;
    info_.table->aim = message.direction;
    if (info_.table->legal.place) info_.table->cue = message.cue;
}

void RemoteMatch::on(const protocol::ShotStarted& message) {
    if (!info_.table) return;
    aim_unsent_ = false;
    info_.table->phase = Phase::kPlaying;
    info_.clock_ends.reset();
    info_.table->shot = message.shot;
    ShotTimeline timeline(positions_of(message.scene));
    playback_.begin({message.shot, message.scene, info_.table->state.cue_ball, std::move(timeline),
                     std::nullopt});
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
    info_.effects = message.effects;
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

void RemoteMatch::command(ClientBody body) {
    transport_.send(sent_.add(std::move(body)));
}

void RemoteMatch::enter(ClientBody request) {
    protocol::ClientMessage message = sent_.number(std::move(request));
    entry_seq_ = message.seq;
    transport_.send(std::move(message));
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

void RemoteMatch::send_aim() {
    aim_unsent_ = false;
    const auto seat = info_.acting_seat();
    if (!seat) return;
    command(protocol::Aim{*seat, info_.table->aim, info_.table->cue});
    aim_sent_at_ = now_;
}

void RemoteMatch::ping_if_due() {
    if (now_ - pinged_at_ < kPingEvery) return;
    protocol::ClientMessage ping = sent_.number(protocol::Ping{});
    ping_seq_ = ping.seq;
    transport_.send(std::move(ping));
    pinged_at_ = now_;
}

// ---- state

void RemoteMatch::show_table(const TableState& table) {
    const GameState& state = table.state;
    if (state.cue_ball.value >= state.scene.balls.size() || table.legal.seat.value >= kSeatCount)
        return;
    // The aim and the ball in hand are this client's own as long as its turn lasts: what the server
    // says of them is older.
    const bool mine_stand = info_.acting_seat() && info_.table->shot == table.shot &&
                            info_.table->game_number == table.game_number &&
                            info_.table->legal.seat == table.legal.seat;
    const auto before = std::exchange(info_.table, table);
    info_.clock_ends.reset();
    if (table.clock_left_ms) info_.clock_ends = received_at_ + 1e-3 * *table.clock_left_ms;
    if (!before) return;
    if (mine_stand) {
        info_.table->aim = before->aim;
        if (table.legal.place) info_.table->cue = before->cue;
    }
    note_changes(*before);
    note_time_out(*before);
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

void RemoteMatch::note_time_out(const TableState& before) {
    const auto& ruling = info_.table->ruling;
    if (ruling && ruling != before.ruling && ruling->verdict == Verdict::kTimedOut)
        notice_ = ruling_sentence(*ruling, info_);
}

void RemoteMatch::resume_playback(const TableState& table) {
    const Shot* shot = playback_.newest();
    if (table.live || (shot != nullptr && !shot->timeline.complete())) playback_.clear();
    const Scene& scene = table.state.scene;
    if (!table.live || table.live->balls.size() != scene.balls.size()) return;
    ShotTimeline timeline(table.live->balls, table.live->tick * Playback::kStep);
    playback_.begin(
        {table.live->shot, scene, table.state.cue_ball, std::move(timeline), std::nullopt});
}

}  // namespace poolhall::client
