#include "client/lab/effects/effect_cases.hpp"

#include "shared/physics/simulate.hpp"

#include <gtest/gtest.h>

namespace poolhall::lab {
namespace {

constexpr std::size_t kShots = 10;

TEST(KernelCases, HaveShotsForEveryKernelThatItAndNoOtherSimulates) {
    ASSERT_EQ(kernel_names().size(), kernel_cases().size());
    for (std::size_t i = 0; i < kernel_names().size(); ++i) {
        const KernelCase& one = kernel_cases()[i];
        EXPECT_EQ(kernel_names()[i], one.kernel);
        for (const Scene& scene : changed_scenes(one.ensemble, 1, kShots, one.change)) {
            ASSERT_FALSE(check(scene)) << one.kernel << ": " << check(scene)->reason;
            EXPECT_EQ(one.kernel, simulate(scene).kernel);
        }
    }
}

TEST(EffectCases, DoNothingAtZeroStrength) {
    for (const EffectCase& one : effect_cases()) {
        SCOPED_TRACE(one.effect);
        if (!one.zero) continue;
        for (Scene scene : changed_scenes(one.ensemble, 1, kShots, one.present)) {
            ASSERT_FALSE(check(scene)) << check(scene)->reason;
            scene.limits.time = 5;
            Scene absent = scene;
            one.absent(absent);
            one.zero(scene);
            EXPECT_EQ(simulate(absent).hash, simulate(scene).hash);
        }
    }
}

TEST(EffectCases, ChangeWhatHappens) {
    for (const EffectCase& one : effect_cases()) {
        std::size_t changed = 0;
        for (Scene scene : changed_scenes(one.ensemble, 1, kShots, one.present)) {
            const ShotTrace present = simulate(scene);
            one.absent(scene);
            scene.limits.time = present.duration;
            if (simulate(scene).hash != present.hash) ++changed;
        }
        EXPECT_GT(changed, 0U) << one.effect;
    }
}

}  // namespace
}  // namespace poolhall::lab
