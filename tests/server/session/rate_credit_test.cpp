#include "server/session/rate_credit.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr RateCredit::Clock::time_point kNow{};

TEST(RateCredit, AllowsABurstAndThenASteadyRate) {
    RateCredit credit(kNow);
    for (int i = 0; i < 120; ++i)
        EXPECT_TRUE(credit.spend(kNow)) << i;
    EXPECT_FALSE(credit.spend(kNow));
    auto now = kNow + seconds(1);
    for (int i = 0; i < 60; ++i)
        EXPECT_TRUE(credit.spend(now)) << i;
    EXPECT_FALSE(credit.spend(now));
    for (int i = 0; i < 600; ++i)
        EXPECT_TRUE(credit.spend(now += milliseconds(17))) << i;
}

}  // namespace
}  // namespace poolhall::server
