#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

namespace boost::asio {
class io_context;
}

namespace poolhall::server {

/// An event loop and its thread. What is posted to one loop runs in the order of posting, one at a
/// time; so what belongs to a loop needs no lock.
class Loop {
  public:
    using Task = std::function<void()>;

    Loop();
    /// Stops the loop; tasks that have not run are dropped.
    ~Loop();
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;
    Loop(Loop&&) = delete;
    Loop& operator=(Loop&&) = delete;

    void start();
    /// Safe from any other thread, and more than once. The task in progress is finished.
    void stop();
    /// On a stopped loop: runs what is ready, on the calling thread; false if nothing was.
    bool run_ready();
    /// Safe from any thread.
    void post(Task task);

    [[nodiscard]] boost::asio::io_context& context() { return *context_; }

  private:
    std::unique_ptr<boost::asio::io_context> context_;
    std::thread thread_;
};

/// Runs a task at a time, on a loop. Costs nothing while it is not armed. Use it on its loop only;
/// a task that is due when the timer is destroyed or set anew does not run.
class LoopTimer {
  public:
    using Clock = std::chrono::steady_clock;

    explicit LoopTimer(Loop& loop);
    ~LoopTimer() = default;
    LoopTimer(const LoopTimer&) = delete;
    LoopTimer& operator=(const LoopTimer&) = delete;
    LoopTimer(LoopTimer&&) = delete;
    LoopTimer& operator=(LoopTimer&&) = delete;

    void at(Clock::time_point when, Loop::Task task);
    void cancel();

  private:
    struct State;
    std::shared_ptr<State> state_;
};

/// Does something at once, but no more often than once an interval: what is asked for sooner is
/// done, once, when the interval is over.
class Throttle {
  public:
    Throttle(Loop& loop, LoopTimer::Clock::duration interval, Loop::Task action);

    void request();
    void cancel();

  private:
    void run();

    LoopTimer timer_;
    LoopTimer::Clock::duration interval_;
    Loop::Task action_;
    LoopTimer::Clock::time_point next_{};
    bool armed_ = false;
};

}  // namespace poolhall::server
