#include "client/lab/ensembles/ensembles.hpp"

#include "shared/physics/effects/pocket_circles.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace poolhall::lab {

void PrintTo(const Ensemble& ensemble, std::ostream* out) {
    *out << ensemble.name;
}

namespace {

class EnsembleTest : public ::testing::TestWithParam<Ensemble> {};

INSTANTIATE_TEST_SUITE_P(All, EnsembleTest, ::testing::ValuesIn(ensembles()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(EnsembleTest, HasScenesThatTheEventSolverTakes) {
    for (const Scene& scene : scenes_of(GetParam(), 1, 100)) {
        const auto fault = check(scene);
        EXPECT_FALSE(fault) << scene.id << ": " << fault->pointer << " " << fault->reason;
        EXPECT_EQ(scene.solver.kind, SolverKind::kEvent);
    }
}

TEST_P(EnsembleTest, HasNoShotThatBeginsInAPocket) {
    for (const Scene& scene : scenes_of(GetParam(), 1, 1000)) {
        const PocketCircles pockets(scene);
        for (const SceneBall& ball : scene.balls)
            EXPECT_FALSE(pockets.at(xy(ball.state.r))) << scene.id;
    }
}

TEST_P(EnsembleTest, IsTheSameForASeedHoweverManyShots) {
    const auto few = scenes_of(GetParam(), 7, 5);
    const auto many = scenes_of(GetParam(), 7, 9);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
    EXPECT_NE(few[0], many[1]);
    EXPECT_NE(few[0].balls, scenes_of(GetParam(), 8, 1)[0].balls);
}

TEST_P(EnsembleTest, ComesToRest) {
    if (GetParam().name == "bank_chain_100000") return;  // 100,000 events a shot
    for (const Scene& scene : scenes_of(GetParam(), 2, 20))
        EXPECT_EQ(simulate(scene).outcome, Outcome::kRest) << scene.id;
}

TEST(Ensembles, AreFoundByName) {
    EXPECT_EQ(find_ensemble("two_balls")->title, "Two balls");
    EXPECT_EQ(find_ensemble("three_balls"), nullptr);
}

TEST(Ensembles, ChainsHaveAsManyRailsAsTheirNamesSay) {
    for (const auto& [name, rails] :
         {std::pair{"bank_chain_10", 10.0}, {"bank_chain_1000", 1000.0}}) {
        for (const Scene& scene : scenes_of(*find_ensemble(name), 1, 20)) {
            const auto events = static_cast<double>(simulate(scene).events.size());
            EXPECT_NEAR(events - 1, rails, 2) << scene.id;
        }
    }
}

TEST(Winner, OfABreakIsTheFirstBallDown) {
    ShotTrace trace;
    const Ensemble& ensemble = *find_ensemble("nine_ball_break");
    const Scene scene = scenes_of(ensemble, 1, 1)[0];
    trace.balls.resize(scene.balls.size());
    EXPECT_EQ(winner_of(ensemble, scene, trace), std::nullopt);
    ShotEvent down;
    down.kind = EventKind::kBallPocket;
    down.balls[0] = BallIndex{3};
    trace.events.push_back(down);
    EXPECT_EQ(winner_of(ensemble, scene, trace), 3);
    EXPECT_EQ(winner_of(*find_ensemble("one_ball"), scene, trace), std::nullopt);
}

TEST(Winner, OfTheEndGameIsByItsRules) {
    ShotTrace trace;
    const Ensemble& ensemble = *find_ensemble("end_game");
    const Scene scene = scenes_of(ensemble, 1, 1)[0];
    ShotEvent down;
    down.kind = EventKind::kBallPocket;
    down.balls[0] = BallIndex{1};
    trace.events.push_back(down);
    EXPECT_EQ(winner_of(ensemble, scene, trace), 0);  // the 8-ball: the shooter
    down.balls[0] = BallIndex{0};
    trace.events.push_back(down);
    EXPECT_EQ(winner_of(ensemble, scene, trace), 1);  // the cue ball too: the other one
}

}  // namespace
}  // namespace poolhall::lab
