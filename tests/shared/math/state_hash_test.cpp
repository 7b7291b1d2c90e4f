#include "shared/math/state_hash.hpp"

#include "shared/physics/simulate.hpp"
#include "tests/shared/scenes.hpp"

#include <functional>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

template <class... Word>
std::uint64_t hash_of_words(Word... words) {
    StateHash hash;
    (hash.add(words), ...);
    return hash.value();
}

TEST(StateHash, HasTheValuesOfPhysicsMd) {
    EXPECT_EQ("cbf29ce484222325", to_hex(StateHash{}.value()));
    EXPECT_EQ("5a8419103ebe48e4", to_hex(hash_of_words(std::uint64_t{1})));
    EXPECT_EQ("6616e6a718c48c13", to_hex(hash_of_words(std::uint64_t{1}, 1.5)));
}

TEST(StateHash, ZeroHasOneHash) {
    EXPECT_EQ(hash_of_words(0.0), hash_of_words(-0.0));
    EXPECT_NE(hash_of_words(0.0), hash_of_words(5e-324));
}

TEST(StateHash, DependsOnEveryBitAndOnTheOrder) {
    for (unsigned bit = 0; bit < 64; ++bit)
        EXPECT_NE(hash_of_words(std::uint64_t{0}), hash_of_words(std::uint64_t{1} << bit));
    EXPECT_NE(hash_of_words(1.0, 2.0), hash_of_words(2.0, 1.0));
}

TEST(HashOfTrace, CoversKindsBallsTimesAndFinalStates) {
    const Scene scene = testing::break_scene(2, 0, 3);
    const ShotTrace original = simulate(scene);
    ASSERT_GT(original.events.size(), 3U);
    const std::vector<std::function<void(ShotTrace&)>> changes{
        [](ShotTrace& trace) { trace.events[1].kind = EventKind::kBallRail; },
        [](ShotTrace& trace) { trace.events[1].balls[0].value ^= 1U; },
        [](ShotTrace& trace) { trace.events[1].t += 1e-15; },
        [](ShotTrace& trace) { trace.events.pop_back(); },
        [](ShotTrace& trace) { trace.balls[2].motion = Motion::kPocketed; },
        [](ShotTrace& trace) { trace.balls[2].state.r.y += 1e-15; },
        [](ShotTrace& trace) { trace.balls[2].state.w.z = 1e-300; },
    };
    for (const auto& change : changes) {
        ShotTrace trace = original;
        change(trace);
        EXPECT_NE(original.hash, hash_of(trace));
    }
}

TEST(HashOfTrace, DoesNotCoverSamples) {
    const Scene scene = testing::break_scene(2, 0, 3);
    EXPECT_EQ(simulate(scene).hash, simulate(scene, 240).hash);
}

}  // namespace
}  // namespace poolhall
