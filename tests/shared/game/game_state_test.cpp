#include "shared/game/end_game.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <set>
#include <vector>

namespace poolhall {
namespace {

GameState some_state() {
    GameState state = kEndGameRules.new_game(Seat{0});
    state.over = true;
    state.winner = Seat{0};
    return state;
}

/// What differs from some_state() in one field each.
std::vector<GameState> neighbours() {
    const std::vector<std::function<void(GameState&)>> changes{
        [](GameState& state) { state.scene.table.length += 1e-9; },
        [](GameState& state) { state.scene.ball.radius += 1e-9; },
        [](GameState& state) { state.scene.effects.linear_drag->k += 1e-9; },
        [](GameState& state) { state.scene.effects.airborne.emplace(); },
        [](GameState& state) { state.scene.solver.hz += 1; },
        [](GameState& state) { state.scene.limits.events += 1; },
        [](GameState& state) { state.scene.balls[1].id = "9"; },
        [](GameState& state) { state.scene.balls[1].state.r.y += 1e-9; },
        [](GameState& state) { state.scene.balls.pop_back(); },
        [](GameState& state) { state.cue_ball = BallIndex{1}; },
        [](GameState& state) { state.turn = Seat{1}; },
        [](GameState& state) { state.shots = 1; },
        [](GameState& state) { state.over = false; },
        [](GameState& state) { state.winner = Seat{1}; },
        [](GameState& state) { state.winner.reset(); },
        [](GameState& state) { state.part = EndGamePart{false}; },
    };
    std::vector<GameState> states;
    for (const auto& change : changes)
        change(states.emplace_back(some_state()));
    return states;
}

TEST(GameStateHash, ChangesWithEveryField) {
    std::set<std::uint64_t> hashes{hash_of(some_state())};
    for (const GameState& state : neighbours()) {
        EXPECT_NE(some_state(), state);
        EXPECT_TRUE(hashes.insert(hash_of(state)).second) << "change " << hashes.size();
    }
}

TEST(GameStateHash, IsThatOfAnEqualState) {
    EXPECT_EQ(hash_of(some_state()), hash_of(some_state()));
}

TEST(Names, OfVerdictsFaultsAndAccordsAreTheirCodes) {
    EXPECT_EQ("turn_passes", name(Verdict::kTurnPasses));
    EXPECT_EQ("timed_out", name(Verdict::kTimedOut));
    EXPECT_EQ("not_offered", name(Illegal::kNotOffered));
    EXPECT_EQ("out_of_bounds", name(Illegal::kOutOfBounds));
    EXPECT_EQ("rematch", name(Accord::kRematch));
}

}  // namespace
}  // namespace poolhall
