#include "server/room/room.hpp"

#include "server/base/identity.hpp"
#include "server/room/gate.hpp"

#include <algorithm>
#include <spdlog/spdlog.h>

namespace poolhall::server {

using protocol::RejectCode;

namespace {

constexpr auto kAimInterval = std::chrono::milliseconds(33);
/// A thousand spectators who come at once shall not make a million tables.
constexpr auto kSpectatorsInterval = std::chrono::milliseconds(250);
/// A finished game that everybody has left waits this long for a rematch.
constexpr std::chrono::milliseconds kFinishedTimeout = std::chrono::minutes(1);
/// With no seat reserved there is nothing to come back to; long enough for a match that just
/// begins.
constexpr std::chrono::milliseconds kDesertedTimeout = std::chrono::seconds(10);

}  // namespace

Room::Room(Loop& loop, Table table, const RoomServices& services)
    : loop_(loop),
      table_(std::move(table)),
      services_(services),
      followers_(services.shards),
      playout_timer_(loop),
      clock_timer_(loop),
      aim_(loop, kAimInterval, [this] { announce_aim(); }),
      spectators_(loop, kSpectatorsInterval, [this] { announce_table(); }) {
    update_summary();
}

// ---- one at a time

void Room::submit(Request request, RoomCommand command) {
    enqueue([this, request = std::move(request), command = std::move(command)]() mutable {
        handle(std::move(request), command);
    });
}

void Room::disconnect(MemberId member) {
    enqueue([this, member] {
        table_.roster.disconnect(member);
        remove(member);
    });
}

void Room::sweep() {
    enqueue([this] {
        if (!closed_ && abandoned())
            close(table_.roster.deserted() ? "everybody left" : "nobody came back");
    });
}

void Room::pump() {
    while (!storing_ && !queue_.empty()) {
        const Loop::Task task = std::move(queue_.front());
        queue_.pop_front();
        task();
    }
}

void Room::store_all(std::vector<StoreJob> jobs, std::function<void(StoreError)> then) {
    struct Progress {
        std::size_t left;
        StoreError error;
    };

    storing_ = true;
    const auto progress = std::make_shared<Progress>(Progress{jobs.size(), {}});
    // Each completion comes back to the loop, so that `progress` needs no lock.
    const auto done = [self = shared_from_this(), progress,
                       then = std::move(then)](StoreError error) {
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

void Room::handle(Request request, const RoomCommand& command) {
    if (closed_)
        return std::move(request).reject({RejectCode::kUnknownMatch, "The match has been closed."});
    const Gate gate(table_, request.member().id, services_.limits.max_spectators);
    const auto carry_out = [&](const auto& leaf) {
        if (auto refusal = gate(leaf)) return std::move(request).reject(*std::move(refusal));
        on(std::move(request), leaf);
    };
    std::visit([&](const auto& group) { std::visit(carry_out, group); }, command);
}

// ---- telling

void Room::announce_table() {
    keep_clock();
    if (!followers_.empty()) followers_.send(protocol::TableChanged{state_of(table_, unix_ms())});
    update_summary();
}

void Room::announce_aim() {
    if (phase_of(table_) != protocol::Phase::kAiming) return;
    followers_.send(protocol::AimChanged{table_.match.now().legal.seat, table_.aim.direction,
                                         shown_cue_ball(table_)});
}

// ---- the end, and the list

bool Room::abandoned() const {
    if (!followers_.empty() || table_.playout) return false;
    std::chrono::milliseconds linger = services_.limits.idle_timeout;
    if (phase_of(table_) == protocol::Phase::kOver) linger = std::min(linger, kFinishedTimeout);
    if (table_.roster.deserted()) linger = std::min(linger, kDesertedTimeout);
    return Clock::now() - empty_since_ >= linger;
}

void Room::close(const std::string& reason) {
    store({CloseMatchJob{table_.id, {reason, unix_ms()}}}, [this, reason](const auto& error) {
        // Then the next server finds it open, and closes it when nobody comes.
        if (error) spdlog::warn("match {}: its end could not be stored: {}", table_.id, *error);
        closed_ = true;
        clock_timer_.cancel();
        aim_.cancel();
        spectators_.cancel();
        spdlog::info("match {} closed: {}", table_.id, reason);
        services_.closed(*this);
    });
}

void Room::update_summary() {
    const protocol::TableState table = state_of(table_, unix_ms());
    const std::lock_guard lock(summary_mutex_);
    summary_ = {table.match,       table_.roster.open_seat() ? std::string() : table.code,
                table.game,        table.phase,
                table.seats,       table.spectators,
                table.game_number, table.shot};
}

MatchSummary Room::summary() const {
    const std::lock_guard lock(summary_mutex_);
    return summary_;
}

}  // namespace poolhall::server
