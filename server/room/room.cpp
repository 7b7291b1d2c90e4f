#include "server/room/room.hpp"

#include "server/app/identity.hpp"
#include "server/app/log_text.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <array>
#include <spdlog/spdlog.h>
#include <utility>
#include <variant>

namespace poolhall::server {

using protocol::RejectCode;
using protocol::Stream;

namespace {

using Seconds = std::chrono::duration<double>;

constexpr auto kAimInterval = std::chrono::milliseconds(33);
/// A thousand spectators who come at once shall not make a million tables.
constexpr auto kSpectatorsInterval = std::chrono::milliseconds(250);
/// A finished game that everybody has left waits this long for a rematch.
constexpr std::chrono::milliseconds kFinishedTimeout = std::chrono::minutes(1);
/// With no seat reserved there is nothing to come back to; long enough for a match that just
/// begins.
constexpr std::chrono::milliseconds kDesertedTimeout = std::chrono::seconds(10);

}  // namespace

Room::Room(Loop& loop, Match match, const RoomServices& services)
    : loop_(loop),
      match_(std::move(match)),
      services_(services),
      playout_timer_(loop),
      aim_(loop, kAimInterval, [this] { announce_aim(); }),
      spectators_(loop, kSpectatorsInterval, [this] { announce_table(); }) {
    update_summary();
}

// ---- one at a time

void Room::submit(Request request) {
    enqueue([this, request = std::move(request)] { handle(request); });
}

void Room::refuse(Request request, Refusal refusal) {
    enqueue([this, request = std::move(request), refusal = std::move(refusal)] {
        reject(request, refusal);
    });
}

void Room::disconnect(MemberId member) {
    enqueue([this, member] {
        match_.disconnect(member);
        remove(member);
    });
}

void Room::sweep() {
    enqueue([this] {
        if (!closed_ && abandoned())
            close(match_.deserted() ? "everybody left" : "nobody came back");
    });
}

void Room::enqueue(Loop::Task task) {
    loop_.post([self = shared_from_this(), task = std::move(task)]() mutable {
        self->queue_.push_back(std::move(task));
        self->pump();
    });
}

void Room::pump() {
    while (!storing_ && !queue_.empty()) {
        const Loop::Task task = std::move(queue_.front());
        queue_.pop_front();
        task();
    }
}

void Room::store(std::vector<StoreJob> jobs, std::function<void(std::optional<std::string>)> then) {
    struct Progress {
        std::size_t left;
        std::optional<std::string> error;
    };

    storing_ = true;
    const auto progress = std::make_shared<Progress>(Progress{jobs.size(), {}});
    // Each completion comes back to the loop, so that `progress` needs no lock.
    const auto done = [self = shared_from_this(), progress,
                       then = std::move(then)](std::optional<std::string> error) {
        self->loop_.post([self, progress, then, error = std::move(error)] {
            if (error && !progress->error) progress->error = error;
            if (--progress->left > 0) return;
            self->storing_ = false;
            then(progress->error);
            self->pump();
        });
    };
    for (StoreJob& job : jobs)
        services_.store.submit(std::move(job), done);
}

void Room::handle(const Request& request) {
    if (closed_) return reject(request, {RejectCode::kUnknownMatch, "The match has been closed."});
    if (auto refusal =
            check(match_, request.member.id, request.message.body, services_.limits.max_spectators))
        return reject(request, std::move(*refusal));
    std::visit([&](const auto& command) { on(request, command); }, request.message.body);
}

// ---- coming and going

/// Somebody takes a seat, maybe with the whole match still to be begun.
struct Room::Admission {
    Seat seat;
    std::string name;
    Stream stream = Stream::kStates;
    std::vector<StoreJob> before;  ///< stored ahead of the seat
};

void Room::on(const Request& request, const protocol::CreateMatch& command) {
    const protocol::MatchRecord record{match_.id(), std::string(match_.rules().name),
                                       std::string(kServerName), unix_ms()};
    const protocol::GameRecord game{match_.game_number(), match_.game().turn};
    admit(request, {Seat{0},
                    command.name,
                    command.stream,
                    {CreateMatchJob{match_.code(), record}, AppendGameJob{match_.id(), game}}});
}

void Room::on(const Request& request, const protocol::JoinMatch& command) {
    admit(request, {*match_.open_seat(), command.name, command.stream, {}});
}

void Room::admit(const Request& request, const Admission& admission) {
    const std::string token = new_token();
    SeatHolder holder{admission.name, hash_token(token), request.member.id};
    std::vector<StoreJob> jobs = admission.before;
    jobs.push_back(seat_job(admission.seat, holder.name, holder.token));
    const bool created = !admission.before.empty();
    store(std::move(jobs),
          [=, this, seat = admission.seat, stream = admission.stream](const auto& error) {
              if (error) {
                  reject(request, {RejectCode::kStorage, *error});
                  if (created) close("it could not be stored");
                  return;
              }
              match_.take_seat(seat, holder);
              spdlog::info("match {} {}: {} takes seat {}", match_.id(),
                           created ? "created" : "joined", in_quotes(holder.name), seat.value);
              joined(request, stream, token);
          });
}

void Room::on(const Request& request, const protocol::WatchMatch& command) {
    match_.watch(request.member.id, command.name);
    joined(request, command.stream, {});
}

void Room::on(const Request& request, const protocol::Resume& command) {
    if (const auto replaced = match_.resume(hash_token(command.token), request.member.id))
        replace(*replaced);
    joined(request, command.stream, command.token);
}

/// A newer connection has the seats: the older must not come back and take them again.
void Room::replace(MemberId member) {
    if (const Member* older = followers_.find(member))
        older->loop->post([outlet = older->outlet] {
            outlet->close(CloseReason::kPolicy, "Your seat was resumed from another connection.");
        });
    followers_.remove(member);
}

void Room::joined(const Request& request, Stream stream, const std::string& token) {
    const bool seated = !match_.seats_of(request.member.id).empty();
    // To the others first: the newcomer's table already has itself in it.
    if (seated)
        announce_table();
    else
        spectators_.request();
    FanOut::send(request.member,
                 protocol::Joined{request.message.seq, token, match_.seats_of(request.member.id),
                                  match_.table()});
    followers_.add(request.member, stream);
    finish(request);
}

/// A spectator, who may have come without a name, as a player.
SeatHolder Room::newcomer(MemberId member, const std::string& token) const {
    std::string name = match_.spectator_name(member);
    return {name.empty() ? "Guest" : std::move(name), hash_token(token), member};
}

void Room::on(const Request& request, const protocol::TakeSeat& command) {
    const auto seats = match_.seats_of(request.member.id);
    const bool seated = !seats.empty();
    // One token for all of a person's seats; a spectator has none yet and is answered with one.
    const std::string token = seated ? std::string() : new_token();
    const SeatHolder holder =
        seated ? *match_.holder(seats.front()) : newcomer(request.member.id, token);
    store({seat_job(command.seat, holder.name, holder.token)}, [=, this](const auto& error) {
        if (error) return reject(request, {RejectCode::kStorage, *error});
        match_.take_seat(command.seat, holder);
        if (seated)
            accept(request);
        else
            FanOut::send(request.member,
                         protocol::Joined{request.message.seq, token,
                                          match_.seats_of(request.member.id), match_.table()});
        announce_table();
        finish(request);
    });
}

void Room::on(const Request& request, const protocol::LeaveSeat& command) {
    store({seat_job(command.seat, {}, {})}, [=, this](const auto& error) {
        if (error) return reject(request, {RejectCode::kStorage, *error});
        match_.leave_seat(command.seat);
        accept(request);
        announce_table();
        finish(request);
    });
}

void Room::on(const Request& request, const protocol::Leave&) {
    const auto leave = [=, this](const std::optional<std::string>& error) {
        if (error) return reject(request, {RejectCode::kStorage, *error});
        match_.leave(request.member.id);
        accept(request);
        remove(request.member.id);
        request.done({});
    };
    std::vector<StoreJob> jobs;
    for (const Seat seat : match_.seats_of(request.member.id))
        jobs.push_back(seat_job(seat, {}, {}));
    if (jobs.empty()) return leave({});
    store(std::move(jobs), leave);
}

void Room::remove(MemberId member) {
    if (!followers_.find(member)) return;
    followers_.remove(member);
    empty_since_ = Clock::now();
    if (match_.deserted() && followers_.empty() && !closed_) return close("everybody left");
    spectators_.request();
}

// ---- the game

void Room::on(const Request& request, const protocol::Aim& command) {
    match_.set_aim(command.direction);
    accept(request);
    aim_.request();
    finish(request);
}

void Room::on(const Request& request, const protocol::PlaceCueBall& command) {
    match_.place_cue_ball(command.position);
    accept(request);
    aim_.request();
    finish(request);
}

void Room::on(const Request& request, const protocol::Shoot& command) {
    ShotOutcome outcome = match_.rules().play(match_.game(), {command.direction});
    StoreJob job = shot_job(outcome, command.seat);
    store({std::move(job)}, [=, this, outcome = std::move(outcome)](const auto& error) {
        if (error) {
            spdlog::error("match {}: shot not stored: {}", match_.id(), *error);
            return reject(request, {RejectCode::kStorage,
                                    "The shot could not be stored: it was not played."});
        }
        match_.set_aim(command.direction);
        accept(request);
        start_shot(outcome, command.seat);
        finish(request);
    });
}

void Room::on(const Request& request, const protocol::Rematch& command) {
    const bool both = match_.wants_rematch(opponent(command.seat));
    if (both) return start_next_game(request);
    match_.vote_rematch(command.seat);
    accept(request);
    announce_table();
    finish(request);
}

void Room::start_next_game(const Request& request) {
    const protocol::GameRecord record{match_.game_number() + 1, match_.next_first()};
    store({AppendGameJob{match_.id(), record}}, [=, this](const auto& error) {
        if (error) return reject(request, {RejectCode::kStorage, *error});
        match_.start_next_game();
        accept(request);
        announce_table();
        finish(request);
    });
}

void Room::on(const Request& request, const protocol::Ping&) {
    FanOut::send(request.member, protocol::Pong{request.message.seq});
    finish(request);
}

void Room::start_shot(ShotOutcome outcome, Seat seat) {
    protocol::ShotStarted started{
        match_.shots() + 1, seat, outcome.scene, hash_of(outcome.scene), {}};
    const std::uint64_t final_hash = outcome.trace.hash;
    match_.start_shot(std::move(outcome));
    followers_.send(started, Stream::kStates);
    started.final_hash = final_hash;
    followers_.send(started, Stream::kShots);
    services_.counters.shots.fetch_add(1, std::memory_order_relaxed);
    update_summary();
    playout_start_ = Clock::now();
    schedule_tick();
}

/// Deadlines count from the start of the shot, so that lateness never adds up.
void Room::schedule_tick() {
    due_tick_ = match_.playout()->tick() + 1;
    const auto due = std::chrono::duration_cast<Clock::duration>(Seconds(due_tick_ / kPlayoutHz));
    playout_timer_.at(playout_start_ + due, [self = shared_from_this()] { self->tick(); });
}

void Room::tick() {
    const Playout& playout = *match_.playout();
    // A loop that was late skips to the newest tick; its frame has all events since the last one.
    const Seconds elapsed = Clock::now() - playout_start_;
    const auto newest = static_cast<std::uint32_t>(elapsed.count() * kPlayoutHz);
    const std::uint32_t tick = std::min(std::max(due_tick_, newest), playout.last_tick());
    if (tick > playout.tick()) followers_.send(match_.advance(tick), Stream::kStates);
    if (!playout.finished()) return schedule_tick();
    followers_.send(match_.finish_shot());
    update_summary();
}

// ---- telling

void Room::announce_table() {
    if (!followers_.empty()) followers_.send(protocol::TableChanged{match_.table()});
    update_summary();
}

void Room::announce_aim() {
    if (match_.phase() != protocol::Phase::kAiming) return;
    followers_.send(protocol::AimChanged{match_.game().turn, match_.aim(), match_.cue_ball()});
}

void Room::accept(const Request& request) {
    FanOut::send(request.member, protocol::Accepted{request.message.seq});
}

void Room::reject(const Request& request, Refusal refusal) {
    services_.counters.rejects.fetch_add(1, std::memory_order_relaxed);
    FanOut::send(request.member,
                 protocol::Reject{request.message.seq, refusal.code, std::move(refusal.reason)});
    finish(request);
}

/// Where the member is now: whoever follows is in the match.
void Room::finish(const Request& request) {
    if (!followers_.find(request.member.id)) return request.done({});
    request.done({shared_from_this(), !match_.seats_of(request.member.id).empty()});
}

// ---- the end, and the list

bool Room::abandoned() const {
    if (!followers_.empty() || match_.playout()) return false;
    std::chrono::milliseconds linger = services_.limits.idle_timeout;
    if (match_.phase() == protocol::Phase::kOver) linger = std::min(linger, kFinishedTimeout);
    if (match_.deserted()) linger = std::min(linger, kDesertedTimeout);
    return Clock::now() - empty_since_ >= linger;
}

void Room::close(const std::string& reason) {
    store({CloseMatchJob{match_.id(), {reason, unix_ms()}}}, [this, reason](const auto& error) {
        // Then the next server finds it open, and closes it when nobody comes.
        if (error) spdlog::warn("match {}: its end could not be stored: {}", match_.id(), *error);
        closed_ = true;
        aim_.cancel();
        spectators_.cancel();
        spdlog::info("match {} closed: {}", match_.id(), reason);
        services_.closed(*this);
    });
}

void Room::update_summary() {
    const protocol::TableState table = match_.table();
    const std::lock_guard lock(summary_mutex_);
    summary_ = {table.match,       match_.open_seat() ? std::string() : table.code,
                table.game,        table.phase,
                table.seats,       table.spectators,
                table.game_number, table.shot};
}

MatchSummary Room::summary() const {
    const std::lock_guard lock(summary_mutex_);
    return summary_;
}

StoreJob Room::seat_job(Seat seat, const std::string& name, const TokenHash& token) const {
    return SetSeatJob{match_.id(), {seat, name}, token};
}

StoreJob Room::shot_job(const ShotOutcome& outcome, Seat seat) const {
    protocol::ShotRecord record = protocol::shot_record(outcome);
    record.shot = match_.shots() + 1;
    record.game_number = match_.game_number();
    record.seat = seat;
    record.at_ms = unix_ms();
    return AppendShotJob{match_.id(), std::move(record)};
}

}  // namespace poolhall::server
