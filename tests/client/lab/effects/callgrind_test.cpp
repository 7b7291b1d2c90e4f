#include "client/lab/effects/callgrind.hpp"

#include "client/lab/effects/effect_cases.hpp"

#include <gtest/gtest.h>

namespace poolhall::lab {
namespace {

std::vector<Scene> shots(std::size_t count) {
    return changed_scenes("two_balls", 1, count, [](Scene& /*scene*/) {});
}

TEST(Callgrind, CountsTheSameInstructionsEveryTime) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "valgrind cannot run a program with sanitizers";
#endif
    Callgrind callgrind(POOLHALL_LAB);
    const auto one = callgrind.instructions_of(shots(1));
    ASSERT_TRUE(one) << *callgrind.fault();
    EXPECT_GT(*one, 1000);
    EXPECT_EQ(one, callgrind.instructions_of(shots(1)));
    const auto three = callgrind.instructions_of(shots(3));
    ASSERT_TRUE(three);
    EXPECT_GT(*three, 1.5 * *one);
}

TEST(Callgrind, SaysWhatCannotBeCounted) {
    Callgrind callgrind("/nowhere/lab");
    EXPECT_FALSE(callgrind.instructions_of(shots(1)));
    EXPECT_EQ(callgrind.fault(), "valgrind cannot count instructions of /nowhere/lab");
}

}  // namespace
}  // namespace poolhall::lab
