#pragma once

#include "protocol/replay/record.hpp"
#include "server/base/counters.hpp"
#include "server/delivery/fan_out.hpp"
#include "server/net/loop.hpp"
#include "server/room/request.hpp"
#include "server/room/table.hpp"
#include "server/store/replay_store.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace poolhall::server {

/// What is listed of a match.
struct MatchSummary {
    std::string id;
    std::string code;  ///< empty while a seat is open: a code read off a list may watch, not join
    std::string game;
    protocol::Phase phase = protocol::Phase::kWaiting;
    PerSeat<protocol::SeatInfo> seats;
    std::uint32_t spectators = 0;
    std::uint32_t game_number = 1;
    std::uint32_t shots = 0;
};

struct RoomLimits {
    std::uint32_t max_spectators = 1000;
    std::chrono::milliseconds idle_timeout = std::chrono::minutes(30);  ///< with nobody connected
};

/// What all rooms share; outlives them.
struct RoomServices {
    ReplayStore& store;
    Shards& shards;
    Counters& counters;
    RoomLimits limits;
    std::function<void(const Room&)> closed;  ///< called once a room has closed itself
};

/// What a room answers.
using RoomCommand = std::variant<protocol::EntryCommand, protocol::SeatCommand,
                                 protocol::TurnCommand, protocol::TableTalk>;

/// A table on its loop: takes commands one at a time, makes what they do durable before anyone sees
/// it, plays shots out, keeps the shot clock and tells those who follow.
///
/// Commands wait while the store writes for the one before, so a command that fails to be stored
/// has changed nothing.
class Room : public std::enable_shared_from_this<Room> {
  public:
    Room(Loop& loop, Table table, const RoomServices& services);

    // Safe from any thread.
    void submit(Request request, RoomCommand command);
    /// The member's connection is gone.
    void disconnect(MemberId member);
    /// Closes the match if nobody has been connected for long enough.
    void sweep();
    [[nodiscard]] MatchSummary summary() const;

    [[nodiscard]] const std::string& code() const { return table_.code; }

  private:
    using Clock = LoopTimer::Clock;
    using StoreError = JobFailure;

    /// Does `task` on the loop, in its turn.
    template <class Task>
    void enqueue(Task task);
    void pump();
    /// Stores the jobs, then goes on with `then(error)`, on the loop; the queue waits for it.
    template <class Then>
    void store(std::vector<StoreJob>&& jobs, Then then);
    void store_all(std::vector<StoreJob> jobs, std::function<void(StoreError)> then);

    void handle(Request request, const RoomCommand& command);
    // Each has passed the gate.
    void on(Request request, const protocol::CreateMatch& command);
    void on(Request request, const protocol::JoinMatch& command);
    void on(Request request, const protocol::WatchMatch& command);
    void on(Request request, const protocol::Resume& command);
    void on(Request request, const protocol::TakeSeat& command);
    void on(Request request, const protocol::LeaveSeat& command);
    void on(Request request, const protocol::Leave& command);
    void on(Request request, const protocol::MakeMove& command);
    void on(Request request, const protocol::Aim& command);

    // ---- people
    struct Admission;
    void admit(Request request, Admission admission);
    void enter(Request request, protocol::Stream stream, std::string token);
    [[nodiscard]] protocol::Joined joined(MemberId member, std::string token) const;
    void replace(MemberId member);
    [[nodiscard]] SeatHolder newcomer(MemberId member, const std::string& token) const;
    [[nodiscard]] StoreJob seat_job(Seat seat, const std::string& name,
                                    const TokenHash& token) const;
    [[nodiscard]] Standing standing_of(MemberId member);
    void remove(MemberId member);

    // ---- the game
    [[nodiscard]] StoreJob move_job(const MatchStep& step) const;
    void take(MatchStep step, std::chrono::nanoseconds cpu);
    void start_shot(MatchStep step, std::chrono::nanoseconds cpu);
    void schedule_tick();
    void tick();
    void finish_shot();
    void keep_clock();
    void ring_clock(Clock::time_point at);
    void time_out();

    // ---- telling, and the end
    void announce_table();
    void announce_aim();
    void update_summary();
    [[nodiscard]] bool abandoned() const;
    void close(const std::string& reason);

    Loop& loop_;
    Table table_;
    const RoomServices& services_;
    FanOut followers_;
    std::deque<Loop::Task> queue_;
    bool storing_ = false;
    bool closed_ = false;
    Clock::time_point empty_since_ = Clock::now();

    LoopTimer playout_timer_;
    Clock::time_point playout_start_;
    std::uint32_t due_tick_ = 0;  ///< that the playout timer is set to
    LoopTimer clock_timer_;
    bool clock_runs_ = false;
    Throttle aim_;
    Throttle spectators_;

    mutable std::mutex summary_mutex_;
    MatchSummary summary_;
};

// A loop's tasks are copied, what a request goes with is not.

template <class Task>
void Room::enqueue(Task task) {
    loop_.post([self = shared_from_this(), shared = std::make_shared<Task>(std::move(task))] {
        self->queue_.emplace_back([shared] { (*shared)(); });
        self->pump();
    });
}

template <class Then>
void Room::store(std::vector<StoreJob>&& jobs, Then then) {
    store_all(std::move(jobs), [shared = std::make_shared<Then>(std::move(then))](
                                   const StoreError& error) { (*shared)(error); });
}

}  // namespace poolhall::server
