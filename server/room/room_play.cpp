// The game: aims, shots and their playout, rematches.
#include "server/base/identity.hpp"
#include "server/room/room.hpp"
#include "shared/physics/simulate.hpp"

#include <boost/chrono/thread_clock.hpp>

#include <algorithm>
#include <spdlog/spdlog.h>
#include <utility>

namespace poolhall::server {

using protocol::RejectCode;
using protocol::Stream;
using Seconds = std::chrono::duration<double>;

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
    const auto begin = boost::chrono::thread_clock::now();
    ShotOutcome outcome = match_.rules().play(match_.game(), {command.direction});
    const std::chrono::nanoseconds cpu((boost::chrono::thread_clock::now() - begin).count());
    StoreJob job = shot_job(outcome, command.seat);
    store({std::move(job)}, [=, this, outcome = std::move(outcome)](const auto& error) {
        if (error) {
            spdlog::error("match {}: shot not stored: {}", match_.id(), *error);
            return reject(request, {RejectCode::kStorage,
                                    "The shot could not be stored: it was not played."});
        }
        match_.set_aim(command.direction);
        accept(request);
        start_shot(outcome, command.seat, cpu);
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

void Room::start_shot(ShotOutcome outcome, Seat seat, std::chrono::nanoseconds cpu) {
    protocol::ShotStarted started{
        match_.shots() + 1, seat, outcome.scene, hash_of(outcome.scene), {}};
    const std::uint64_t final_hash = outcome.trace.hash;
    services_.counters.shot_costs.add(outcome.trace.solver, outcome.trace.kernel, cpu);
    match_.start_shot(std::move(outcome), cpu);
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

StoreJob Room::shot_job(const ShotOutcome& outcome, Seat seat) const {
    protocol::ShotRecord record = protocol::shot_record(outcome);
    record.shot = match_.shots() + 1;
    record.game_number = match_.game_number();
    record.seat = seat;
    record.at_ms = unix_ms();
    return AppendShotJob{match_.id(), std::move(record)};
}

}  // namespace poolhall::server
