#include "server/net/loop.hpp"

#include <gtest/gtest.h>
#include <thread>

namespace poolhall::server {
namespace {

using std::chrono::milliseconds;

void run_for(Loop& loop, milliseconds time) {
    const auto end = LoopTimer::Clock::now() + time;
    while (LoopTimer::Clock::now() < end) {
        loop.run_ready();
        std::this_thread::sleep_for(milliseconds(1));
    }
}

TEST(Throttle, ActsAtOnceAndThenOnceAnInterval) {
    Loop loop;
    int acted = 0;
    Throttle throttle(loop, milliseconds(50), [&] { ++acted; });
    throttle.request();
    EXPECT_EQ(acted, 1);
    for (int i = 0; i < 10; ++i)
        throttle.request();
    EXPECT_EQ(acted, 1);
    run_for(loop, milliseconds(80));
    EXPECT_EQ(acted, 2) << "what came too soon is done, once";
    run_for(loop, milliseconds(80));
    EXPECT_EQ(acted, 2) << "nothing was asked for";
    throttle.request();
    EXPECT_EQ(acted, 3);
}

TEST(Throttle, CancelledActsNoMore) {
    Loop loop;
    int acted = 0;
    Throttle throttle(loop, milliseconds(20), [&] { ++acted; });
    throttle.request();
    throttle.request();
    throttle.cancel();
    run_for(loop, milliseconds(50));
    EXPECT_EQ(acted, 1);
}

TEST(LoopTimer, TimerThatIsSetAnewRingsForTheLastTimeOnly) {
    Loop loop;
    LoopTimer timer(loop);
    std::string rang;
    timer.at(LoopTimer::Clock::now(), [&] { rang += "a"; });
    timer.at(LoopTimer::Clock::now() + milliseconds(10), [&] { rang += "b"; });
    run_for(loop, milliseconds(40));
    EXPECT_EQ(rang, "b");
}

}  // namespace
}  // namespace poolhall::server
