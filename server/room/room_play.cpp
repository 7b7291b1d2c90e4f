// The game: aims, moves, the playout of shots, the shot clock.
#include "server/base/cpu_time.hpp"
#include "server/base/identity.hpp"
#include "server/room/room.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <spdlog/spdlog.h>

namespace poolhall::server {

using protocol::RejectCode;
using protocol::Stream;
using Seconds = std::chrono::duration<double>;

namespace {

/// After a time-out that could not be stored.
constexpr auto kClockRetry = std::chrono::seconds(1);

}  // namespace

void Room::on(Request request, const protocol::Aim& command) {
    table_.aim = {command.direction, {}};
    if (command.cue) table_.aim.cue = nearest_place(*table_.match.now().legal.place, *command.cue);
    const MemberId member = request.member().id;
    std::move(request).accept(standing_of(member));
    aim_.request();
}

/// Store, then show.
void Room::on(Request request, const protocol::MakeMove& command) {
    const auto begin = cpu_time_of_thread();
    MatchStep step = table_.match.play(command.seat, command.move, unix_ms());
    const auto cpu = cpu_time_of_thread() - begin;
    StoreJob job = move_job(step);
    store({std::move(job)}, [this, cpu, request = std::move(request),
                             step = std::move(step)](const auto& error) mutable {
        if (error) {
            spdlog::error("match {}: move not stored: {}", table_.id, *error);
            return std::move(request).reject(
                {RejectCode::kStorage, "The move could not be stored: it was not played."});
        }
        const MemberId member = request.member().id;
        std::move(request).accept(standing_of(member));
        take(std::move(step), cpu);
    });
}

StoreJob Room::move_job(const MatchStep& step) const {
    return AppendMoveJob{table_.id, protocol::move_record(step)};
}

void Room::take(MatchStep step, std::chrono::nanoseconds cpu) {
    if (step.shot()) return start_shot(std::move(step), cpu);
    table_.commit(std::move(step), unix_ms());
    announce_table();
}

void Room::start_shot(MatchStep step, std::chrono::nanoseconds cpu) {
    table_.aim = {std::get<Shoot>(step.made.move).strike.direction, {}};
    const Playout& playout = table_.playout.emplace(std::move(step), cpu);
    keep_clock();
    services_.counters.shot_costs.add(playout.trace().solver, playout.trace().kernel, cpu);
    services_.counters.shots.fetch_add(1, std::memory_order_relaxed);
    for (const Stream stream : kValues<Stream>)
        followers_.send(playout.started(stream), stream);
    update_summary();
    playout_start_ = Clock::now();
    schedule_tick();
}

/// Deadlines count from the start of the shot, so that lateness never adds up.
void Room::schedule_tick() {
    due_tick_ = table_.playout->tick() + 1;
    const auto due = std::chrono::duration_cast<Clock::duration>(Seconds(due_tick_ / kPlayoutHz));
    playout_timer_.at(playout_start_ + due, [self = shared_from_this()] { self->tick(); });
}

void Room::tick() {
    Playout& playout = *table_.playout;
    // A loop that was late skips to the newest tick; its frame has all events since the last one.
    const Seconds elapsed = Clock::now() - playout_start_;
    const auto newest = static_cast<std::uint32_t>(elapsed.count() * kPlayoutHz);
    const std::uint32_t tick = std::min(std::max(due_tick_, newest), playout.last_tick());
    if (tick > playout.tick()) followers_.send(playout.advance(tick), Stream::kStates);
    if (!playout.finished()) return schedule_tick();
    finish_shot();
}

void Room::finish_shot() {
    Playout shown = *std::exchange(table_.playout, std::nullopt);
    protocol::ShotEnded ended = shown.ended();
    table_.commit(std::move(shown).take_step(), unix_ms());
    keep_clock();
    ended.table = state_of(table_, unix_ms());
    followers_.send(ended);
    update_summary();
}

// ---- the shot clock

/// Sets the clock's timer to what the table is now. A clock that stood still begins anew.
void Room::keep_clock() {
    const bool runs = clock_runs(table_) && !closed_;
    if (runs && !clock_runs_) table_.match.start_clock(unix_ms());
    clock_runs_ = runs;
    if (!runs) return clock_timer_.cancel();
    const std::chrono::milliseconds left(*table_.match.clock_ends_ms() - unix_ms());
    ring_clock(Clock::now() + left);
}

void Room::ring_clock(Clock::time_point at) {
    clock_timer_.at(at, [self = shared_from_this()] {
        self->enqueue([room = self.get()] { room->time_out(); });
    });
}

/// Unless a move came before it.
void Room::time_out() {
    const Seat seat = table_.match.now().legal.seat;
    const std::int64_t now = unix_ms();
    if (!clock_runs_ || table_.match.find_fault(seat, TimeOut{}, now)) return;
    MatchStep step = table_.match.play(seat, TimeOut{}, now);
    StoreJob job = move_job(step);
    store({std::move(job)}, [this, step = std::move(step)](const auto& error) mutable {
        if (!error) return take(std::move(step), {});
        spdlog::error("match {}: time-out not stored: {}", table_.id, *error);
        ring_clock(Clock::now() + kClockRetry);
    });
}

}  // namespace poolhall::server
