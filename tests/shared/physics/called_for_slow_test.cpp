#include "client/lab/corpora/real_play.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/shared/random.hpp"

#include <gtest/gtest.h>

namespace poolhall {
namespace {

TEST(CalledForSlow, AMillionShotsOfRealPlayAreTheSameByAllThatTheyName) {
    constexpr int kShotsOfAKind = 250'000;
    Simulator simulator;
    Simulator other;
    ShotTrace proven;
    ShotTrace whole;
    for (const lab::PlayKind& kind : lab::kinds_of_play()) {
        testing::Random random(14);
        for (int shot = 0; shot < kShotsOfAKind; ++shot) {
            const Scene scene = kind.make(random);
            if (check(scene)) continue;
            simulator.simulate(scene, 0, proven);
            ASSERT_TRUE(other.simulate_by("everything", scene, 0, whole));
            ASSERT_EQ(whole.hash, proven.hash) << kind.name << ' ' << shot;
        }
    }
}

}  // namespace
}  // namespace poolhall
