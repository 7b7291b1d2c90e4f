#pragma once

#include "server/base/counters.hpp"
#include "server/delivery/fan_out.hpp"
#include "server/delivery/outlet.hpp"
#include "server/net/loop.hpp"
#include "server/room/gate.hpp"
#include "server/room/match.hpp"
#include "server/store/replay_store.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace poolhall::server {

/// What is listed of a match.
struct MatchSummary {
    std::string id;
    std::string code;  ///< empty while a seat is open: a code read off a list may watch, not join
    std::string game;
    protocol::Phase phase = protocol::Phase::kWaiting;
    std::array<protocol::SeatInfo, kSeatCount> seats;
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
    Counters& counters;
    RoomLimits limits;
    std::function<void(const Room&)> closed;  ///< called once a room has closed itself
};

/// A match on its loop: takes commands one at a time, makes what they do durable before anyone sees
/// it, plays shots out and tells those who follow.
///
/// Commands wait while the store writes for the one before, so a command that fails to be stored
/// has changed nothing.
class Room : public std::enable_shared_from_this<Room> {
  public:
    Room(Loop& loop, Match match, const RoomServices& services);

    // Safe from any thread.
    void submit(Request request);
    /// Answers a command of a follower that is refused before it comes to the match, in its turn.
    void refuse(Request request, Refusal refusal);
    /// The member's connection is gone.
    void disconnect(MemberId member);
    /// Closes the match if nobody has been connected for long enough.
    void sweep();
    [[nodiscard]] MatchSummary summary() const;

    [[nodiscard]] const std::string& code() const { return match_.code(); }

  private:
    using Clock = LoopTimer::Clock;

    void enqueue(Loop::Task task);
    void pump();
    /// Stores the jobs, then goes on with `then`, on the loop; the queue waits for it.
    void store(std::vector<StoreJob> jobs,
               std::function<void(std::optional<std::string> error)> then);

    void handle(const Request& request);
    void on(const Request& request, const protocol::CreateMatch& command);
    void on(const Request& request, const protocol::JoinMatch& command);
    void on(const Request& request, const protocol::WatchMatch& command);
    void on(const Request& request, const protocol::Resume& command);
    void on(const Request& request, const protocol::TakeSeat& command);
    void on(const Request& request, const protocol::LeaveSeat& command);
    void on(const Request& request, const protocol::Aim& command);
    void on(const Request& request, const protocol::PlaceCueBall& command);
    void on(const Request& request, const protocol::Shoot& command);
    void on(const Request& request, const protocol::Rematch& command);
    void on(const Request& request, const protocol::Leave& command);
    void on(const Request& request, const protocol::Ping& command);

    struct Admission;
    void admit(const Request& request, const Admission& admission);
    void joined(const Request& request, protocol::Stream stream, const std::string& token);
    void replace(MemberId member);
    [[nodiscard]] SeatHolder newcomer(MemberId member, const std::string& token) const;
    [[nodiscard]] StoreJob seat_job(Seat seat, const std::string& name,
                                    const TokenHash& token) const;
    [[nodiscard]] StoreJob shot_job(const ShotOutcome& outcome, Seat seat) const;

    void start_shot(ShotOutcome outcome, Seat seat, std::chrono::nanoseconds cpu);
    void schedule_tick();
    void tick();
    void start_next_game(const Request& request);
    void announce_table();
    void announce_aim();
    void update_summary();
    void remove(MemberId member);
    void close(const std::string& reason);
    [[nodiscard]] bool abandoned() const;

    void accept(const Request& request);
    void reject(const Request& request, Refusal refusal);
    void finish(const Request& request);

    Loop& loop_;
    Match match_;
    const RoomServices& services_;
    FanOut followers_;
    std::deque<Loop::Task> queue_;
    bool storing_ = false;
    bool closed_ = false;
    Clock::time_point empty_since_ = Clock::now();

    LoopTimer playout_timer_;
    Clock::time_point playout_start_;
    std::uint32_t due_tick_ = 0;  ///< that the playout timer is set to
    Throttle aim_;
    Throttle spectators_;

    mutable std::mutex summary_mutex_;
    MatchSummary summary_;
};

}  // namespace poolhall::server
