#include "server/net/loop.hpp"

#include "server/net/asio.hpp"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>

#include <cstdint>
#include <utility>

namespace poolhall::server {

Loop::Loop() : context_(std::make_unique<net::io_context>(1)) {}

Loop::~Loop() {
    stop();
}

void Loop::start() {
    thread_ = std::thread([this] {
        const auto work = net::make_work_guard(*context_);
        context_->run();
    });
}

void Loop::stop() {
    context_->stop();
    if (thread_.joinable()) thread_.join();
}

bool Loop::run_ready() {
    context_->restart();
    return context_->poll() > 0;
}

void Loop::post(Task task) {
    net::post(*context_, std::move(task));
}

struct LoopTimer::State {
    explicit State(Loop& loop) : timer(loop.context().get_executor()) {}

    net::Timer timer;
    std::uint64_t arming = 0;  ///< tells a handler that was already queued that it is out of date
};

LoopTimer::LoopTimer(Loop& loop) : state_(std::make_shared<State>(loop)) {}

void LoopTimer::at(Clock::time_point when, Loop::Task task) {
    state_->timer.expires_at(when);
    state_->timer.async_wait([state = std::weak_ptr(state_), arming = ++state_->arming,
                              task = std::move(task)](net::error_code error) {
        const auto alive = state.lock();
        if (!error && alive && alive->arming == arming) task();
    });
}

void LoopTimer::cancel() {
    ++state_->arming;
    state_->timer.cancel();
}

Throttle::Throttle(Loop& loop, LoopTimer::Clock::duration interval, Loop::Task action)
    : timer_(loop), interval_(interval), action_(std::move(action)) {}

void Throttle::request() {
    if (armed_) return;
    if (LoopTimer::Clock::now() >= next_) return run();
    armed_ = true;
    timer_.at(next_, [this] { run(); });
}

void Throttle::cancel() {
    armed_ = false;
    timer_.cancel();
}

void Throttle::run() {
    armed_ = false;
    next_ = LoopTimer::Clock::now() + interval_;
    action_();
}

}  // namespace poolhall::server
