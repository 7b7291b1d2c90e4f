#include "shared/analysis/agreement.hpp"

#include <gtest/gtest.h>
#include <initializer_list>

namespace poolhall::analysis {
namespace {

constexpr BallIndex kCue{0};
constexpr BallIndex kOne{1};
constexpr BallIndex kTwo{2};

ShotEvent of_one(double t, EventKind kind, BallIndex ball) {
    ShotEvent event;
    event.t = t;
    event.kind = kind;
    event.balls[0] = ball;
    return event;
}

ShotEvent hit(double t, BallIndex a, BallIndex b) {
    ShotEvent event = of_one(t, EventKind::kBallBall, a);
    event.ball_count = 2;
    event.balls[1] = b;
    return event;
}

ShotEvent at_rail(double t, BallIndex ball, Rail rail) {
    ShotEvent event = of_one(t, EventKind::kBallRail, ball);
    event.rail = rail;
    return event;
}

ShotEvent down(double t, BallIndex ball, Pocket pocket) {
    ShotEvent event = of_one(t, EventKind::kBallPocket, ball);
    event.pocket = pocket;
    return event;
}

ShotEvent rest(double t, BallIndex ball) {
    return of_one(t, EventKind::kRollToRest, ball);
}

/// A shot of three balls.
ShotTrace trace_of(std::initializer_list<ShotEvent> events) {
    ShotTrace trace;
    trace.events = events;
    trace.balls.resize(3);
    trace.duration = events.size() == 0 ? 0 : trace.events.back().t;
    return trace;
}

Scene three_balls() {
    Scene scene;
    scene.balls = {{"cue", {}}, {"1", {}}, {"2", {}}};
    return scene;
}

TEST(SameEvent, TellsKindsBallsRailsAndPockets) {
    EXPECT_TRUE(is_same_event(hit(1, kCue, kOne), hit(2, kCue, kOne)));
    EXPECT_TRUE(is_same_event(hit(1, kCue, kOne), hit(1, kOne, kCue)));
    EXPECT_FALSE(is_same_event(hit(1, kCue, kOne), hit(1, kCue, kTwo)));
    EXPECT_FALSE(is_same_event(rest(1, kCue), of_one(1, EventKind::kSlideToRoll, kCue)));
    EXPECT_FALSE(is_same_event(rest(1, kCue), rest(1, kOne)));
    EXPECT_TRUE(is_same_event(at_rail(1, kCue, Rail::kEast), at_rail(2, kCue, Rail::kEast)));
    EXPECT_FALSE(is_same_event(at_rail(1, kCue, Rail::kEast), at_rail(1, kCue, Rail::kNorth)));
    EXPECT_FALSE(is_same_event(down(1, kCue, Pocket::kNorth), down(1, kCue, Pocket::kSouth)));
}

TEST(Agreement, OfEqualTracesReachesTheirEnd) {
    const ShotTrace a = trace_of({hit(0.5, kCue, kOne), rest(2, kCue), rest(3, kOne)});
    const ShotTrace b = trace_of({hit(0.6, kCue, kOne), rest(2.2, kCue), rest(3.3, kOne)});
    const Agreement both = agreement(a, b);
    EXPECT_TRUE(both.complete());
    EXPECT_EQ(both.matching.size(), 3U);
    EXPECT_EQ(both.horizon, 3);
    EXPECT_EQ(first_difference(three_balls(), both, a, b, "euler:30"), "");
}

TEST(Agreement, DoesNotCareWhichOfTwoBallsThatHaveNotMetIsFirst) {
    const ShotTrace a = trace_of({hit(0.5, kCue, kOne), rest(2, kCue), rest(2.1, kOne)});
    const ShotTrace b = trace_of({hit(0.5, kCue, kOne), rest(2, kOne), rest(2.1, kCue)});
    const Agreement both = agreement(a, b);
    EXPECT_TRUE(both.complete());
    EXPECT_EQ(both.matching[1], (std::pair<std::size_t, std::size_t>{1, 2}));
}

TEST(Agreement, CaresInWhichOrderOneBallDoesThings) {
    const ShotTrace a =
        trace_of({at_rail(1, kCue, Rail::kEast), at_rail(1.1, kCue, Rail::kNorth), rest(2, kCue)});
    const ShotTrace b =
        trace_of({at_rail(1, kCue, Rail::kNorth), at_rail(1.2, kCue, Rail::kEast), rest(2, kCue)});
    const Agreement both = agreement(a, b);
    EXPECT_TRUE(both.matching.empty());
    EXPECT_EQ(both.lacking, 0U);
    EXPECT_EQ(both.instead, 0U);
    EXPECT_EQ(both.horizon, 1);
}

TEST(Agreement, EndsWhereAnImpactIsMissed) {
    const ShotTrace a = trace_of(
        {hit(0.5, kCue, kOne), hit(0.8, kOne, kTwo), rest(2, kCue), rest(3, kOne), rest(4, kTwo)});
    const ShotTrace b = trace_of({hit(0.5, kCue, kOne), rest(2, kCue), rest(3.5, kOne)});
    const Agreement both = agreement(a, b);
    EXPECT_EQ(both.matching.size(), 1U);
    EXPECT_EQ(both.lacking, 1U);
    EXPECT_EQ(both.instead, 2U);
    EXPECT_EQ(both.horizon, 0.8);
    EXPECT_EQ(first_difference(three_balls(), both, a, b, "euler:30"),
              "at 0.8 s 1 hits 2, but not in euler:30, where at 3.5 s 1 comes to rest instead");
}

TEST(Agreement, EndsWhereAnImpactIsInvented) {
    const ShotTrace a = trace_of({hit(0.5, kCue, kOne), rest(2, kCue), rest(3, kOne)});
    const ShotTrace b = trace_of({hit(0.5, kCue, kOne), hit(0.7, kOne, kTwo), rest(2, kCue),
                                  rest(2.5, kOne), rest(4, kTwo)});
    const Agreement both = agreement(a, b);
    EXPECT_EQ(both.matching.size(), 2U);
    EXPECT_EQ(both.lacking, 2U);
    EXPECT_EQ(both.instead, 1U);
    EXPECT_EQ(both.horizon, 0.7);
}

TEST(Agreement, AnEventTooManyAtTheEndIsADifference) {
    const ShotTrace a = trace_of({rest(2, kCue)});
    const ShotTrace b = trace_of({rest(2, kCue), hit(1.5, kOne, kTwo)});
    const Agreement both = agreement(a, b);
    EXPECT_EQ(both.matching.size(), 1U);
    EXPECT_FALSE(both.lacking);
    EXPECT_EQ(both.instead, 1U);
    EXPECT_EQ(both.horizon, 1.5);
    EXPECT_EQ(first_difference(three_balls(), both, a, b, "overlap:30"),
              "at 1.5 s 1 hits 2 in overlap:30 only");
}

TEST(Agreement, AnEventTooFewAtTheEndIsADifference) {
    const ShotTrace a = trace_of({rest(2, kCue), rest(3, kOne)});
    const ShotTrace b = trace_of({rest(2, kCue)});
    const Agreement both = agreement(a, b);
    EXPECT_EQ(both.lacking, 1U);
    EXPECT_FALSE(both.instead);
    EXPECT_EQ(first_difference(three_balls(), both, a, b, "euler:30"),
              "at 3 s 1 comes to rest, but not in euler:30");
}

TEST(Agreement, AnImpactMustBeTheNextThingForBothBalls) {
    const ShotTrace a = trace_of({hit(1, kCue, kOne)});
    const ShotTrace b = trace_of({rest(0.9, kOne), hit(1, kCue, kOne)});
    const Agreement both = agreement(a, b);
    EXPECT_EQ(both.lacking, 0U);
    EXPECT_EQ(both.instead, 0U);
    EXPECT_EQ(both.horizon, 0.9);
}

TEST(InWords, NamesRailsAndPockets) {
    const Scene scene = three_balls();
    EXPECT_EQ(in_words(scene, at_rail(1, kTwo, Rail::kEast)), "2 meets rail E");
    EXPECT_EQ(in_words(scene, down(1, kCue, Pocket::kNorthEast)), "cue drops into NE");
}

TEST(RestDistance, IsThatOfEachBall) {
    ShotTrace a = trace_of({});
    ShotTrace b = trace_of({});
    a.balls[1].state.r = {1, 2, 0};
    b.balls[1].state.r = {4, 6, 0};
    EXPECT_EQ(rest_distances(a, b), (std::vector<double>{0, 5, 0}));
}

TEST(SameVerdict, LooksAtBallsThatAreGone) {
    ShotTrace a = trace_of({});
    ShotTrace b = trace_of({});
    a.balls[0].motion = Motion::kStationary;
    b.balls[0].motion = Motion::kSpinning;
    EXPECT_TRUE(is_same_verdict(a, b));
    a.balls[1].motion = Motion::kPocketed;
    EXPECT_FALSE(is_same_verdict(a, b));
    b.balls[1].motion = Motion::kPocketed;
    EXPECT_TRUE(is_same_verdict(a, b));
    b.balls[1].pocket = Pocket::kSouth;
    EXPECT_FALSE(is_same_verdict(a, b));
    b.balls[1].motion = Motion::kOffTable;
    EXPECT_FALSE(is_same_verdict(a, b));
}

TEST(FirstPocketed, IsTheFirstInTime) {
    EXPECT_EQ(first_pocketed(trace_of({rest(1, kCue)})), std::nullopt);
    EXPECT_EQ(
        first_pocketed(trace_of({down(1, kTwo, Pocket::kNorth), down(2, kOne, Pocket::kNorth)})),
        kTwo);
}

TEST(Collisions, AreCountedPairByPair) {
    const ShotTrace a =
        trace_of({hit(1, kCue, kOne), hit(2, kCue, kOne), hit(3, kOne, kTwo), rest(4, kOne)});
    const ShotTrace b = trace_of({hit(1, kOne, kCue), hit(2, kCue, kTwo), hit(3, kTwo, kOne)});
    const CollisionCounts counts = compare_collisions(a, b);
    EXPECT_EQ(counts.missed, 1U);
    EXPECT_EQ(counts.invented, 1U);
    EXPECT_EQ(compare_collisions(a, a).missed, 0U);
}

}  // namespace
}  // namespace poolhall::analysis
