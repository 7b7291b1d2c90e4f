#include "server/net/loop.hpp"

#include <gtest/gtest.h>
#include <thread>

namespace poolhall::server {
namespace {

using Clock = LoopTimer::Clock;
using namespace std::chrono_literals;

/// Runs the loop on this thread for a while, or until `done`.
template <class Done>
bool run(Loop& loop, Clock::duration limit, Done done) {
    for (const auto end = Clock::now() + limit; Clock::now() < end;) {
        if (done()) return true;
        if (!loop.run_ready()) std::this_thread::sleep_for(1ms);
    }
    return done();
}

TEST(Throttle, DoesTheFirstRequestAtOnce) {
    Loop loop;
    int done = 0;
    Throttle throttle(loop, 1h, [&] { ++done; });
    EXPECT_EQ(done, 0);
    throttle.request();
    EXPECT_EQ(done, 1);
}

TEST(Throttle, DoesWhatIsAskedForTooSoonOnceWhenTheIntervalIsOver) {
    constexpr auto kInterval = 50ms;
    Loop loop;
    std::vector<Clock::time_point> done;
    Throttle throttle(loop, kInterval, [&] { done.push_back(Clock::now()); });
    for (int i = 0; i < 100; ++i)
        throttle.request();
    EXPECT_EQ(done.size(), 1U);
    EXPECT_TRUE(run(loop, 10s, [&] { return done.size() == 2; }));
    EXPECT_GE(done[1] - done[0], kInterval);
    EXPECT_FALSE(run(loop, 3 * kInterval, [&] { return done.size() > 2; })) << "nobody asked";
}

TEST(Throttle, IsIdleAgainAfterAnIntervalWithoutRequests) {
    Loop loop;
    int done = 0;
    Throttle throttle(loop, 5ms, [&] { ++done; });
    throttle.request();
    std::this_thread::sleep_for(10ms);
    throttle.request();
    EXPECT_EQ(done, 2);
}

TEST(Throttle, DoesNothingMoreOnceItIsCancelled) {
    Loop loop;
    int done = 0;
    Throttle throttle(loop, 20ms, [&] { ++done; });
    throttle.request();
    throttle.request();
    throttle.cancel();
    EXPECT_FALSE(run(loop, 60ms, [&] { return done > 1; }));
    throttle.request();
    EXPECT_EQ(done, 2);
}

TEST(Throttle, MayBeAskedAgainByWhatItDoes) {
    Loop loop;
    int done = 0;
    std::function<void()> again;
    Throttle throttle(loop, 5ms, [&] {
        if (++done < 4) again();
    });
    again = [&] { throttle.request(); };
    throttle.request();
    EXPECT_EQ(done, 1);
    EXPECT_TRUE(run(loop, 10s, [&] { return done == 4; }));
}

TEST(LoopTimer, RunsTheLastTaskThatItWasGiven) {
    Loop loop;
    LoopTimer timer(loop);
    int done = 0;
    timer.at(Clock::now(), [&] { done = 1; });
    timer.at(Clock::now(), [&] { done = 2; });
    EXPECT_TRUE(run(loop, 10s, [&] { return done != 0; }));
    EXPECT_EQ(done, 2);
}

TEST(LoopTimer, RunsNothingOnceItIsGone) {
    Loop loop;
    int done = 0;
    {
        LoopTimer timer(loop);
        timer.at(Clock::now(), [&] { done = 1; });
    }
    EXPECT_FALSE(run(loop, 20ms, [&] { return done != 0; }));
}

}  // namespace
}  // namespace poolhall::server
