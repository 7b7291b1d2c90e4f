#include "server/room/room.hpp"

#include "server/base/identity.hpp"

#include <algorithm>
#include <spdlog/spdlog.h>
#include <utility>
#include <variant>

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

}  // namespace poolhall::server
