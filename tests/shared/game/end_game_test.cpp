#include "shared/game/end_game.hpp"

#include "shared/physics/simulate.hpp"
#include "tests/shared/game/played_shot.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/traces.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace poolhall {
namespace {

using test::PlayedShot;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const Ruleset& kRules = kEndGameRules;

GameState new_game() {
    return kRules.new_game(Seat{0});
}

PlayedShot shoot(const GameState& state, Vec2 direction) {
    return test::shoot(kRules, state, direction);
}

/// The first thing that the rules find wrong with a move in this state.
std::optional<IllegalMove> fault_of(const GameState& state, const Move& move) {
    return find_fault(kRules.legal(state), move);
}

/// The code of that, if anything is wrong.
std::optional<Illegal> refused(const GameState& state, const Move& move) {
    const auto fault = fault_of(state, move);
    return fault ? std::optional(fault->code) : std::nullopt;
}

/// The state after a legal move that is no shot.
GameState played(const GameState& state, const Move& move) {
    const Legal legal = kRules.legal(state);
    EXPECT_FALSE(find_fault(legal, move));
    return kRules.play(state, completed(legal, move)).state;
}

Stroke towards(Vec2 direction) {
    Stroke stroke;
    stroke.direction = direction;
    return stroke;
}

double edge_y() {
    return inset({end_game::kLength, end_game::kWidth}, BallSpec{}.radius).y;
}

/// A game whose balls are at the given places.
GameState game_at(Vec2 cue, Vec2 eight) {
    GameState state = new_game();
    set_xy(state.scene.balls[0].state.r, cue);
    set_xy(state.scene.balls[1].state.r, eight);
    return state;
}

/// The outcome of the first of many random shots from random places that `wanted` accepts.
PlayedShot find_shot(const std::function<bool(const PlayedShot&)>& wanted) {
    testing::Random random(8);
    for (int i = 0; i < 20000; ++i) {
        const GameState state = game_at({random.uniform(-0.7, -0.1), random.uniform(-0.3, 0.3)},
                                        {random.uniform(0.1, 0.7), random.uniform(-0.3, 0.3)});
        PlayedShot outcome = shoot(state, random.direction());
        if (wanted(outcome)) return outcome;
    }
    ADD_FAILURE() << "no such shot";
    return {};
}

std::optional<double> time_pocketed(const PlayedShot& outcome, std::uint16_t ball) {
    for (const ShotEvent& event : testing::events_of(outcome.trace, EventKind::kBallPocket)) {
        if (event.balls[0].value == ball) return event.t;
    }
    return std::nullopt;
}

TEST(EndGame, StartsAsTheOriginal) {
    const GameState state = kRules.new_game(Seat{1});
    EXPECT_FALSE(check(state.scene));
    EXPECT_EQ(Seat{1}, state.turn);
    EXPECT_FALSE(state.over);
    EXPECT_EQ(0U, state.shots);
    EXPECT_NEAR(1.550, state.scene.table.length, 5e-4);
    EXPECT_NEAR(0.720, state.scene.table.width, 5e-4);
    ASSERT_EQ(2U, state.scene.balls.size());
    EXPECT_EQ("cue", state.scene.balls[state.cue_ball.value].id);
    // x = 295 and 732 of 1024 px, the playfield from 78 to 946.
    EXPECT_NEAR((295 - 512) * end_game::kPixel, state.scene.balls[0].state.r.x, 1e-15);
    EXPECT_NEAR((732 - 512) * end_game::kPixel, state.scene.balls[1].state.r.x, 1e-15);
    EXPECT_NEAR(2.679, end_game::kShotSpeed, 5e-4);
}

TEST(EndGame, CueBallMovesOnTheBaseLineBetweenTheRails) {
    GameState state = played(new_game(), Place{{end_game::kBaseLineX, 0.2}});
    EXPECT_EQ((Vec3{end_game::kBaseLineX, 0.2, 0}), state.scene.balls[0].state.r);
    state = played(state, Place{{end_game::kBaseLineX + 1e-7, -edge_y()}});
    EXPECT_EQ((Vec3{end_game::kBaseLineX, -edge_y(), 0}), state.scene.balls[0].state.r);
    state = played(state, Place{{end_game::kBaseLineX, std::nextafter(edge_y(), 1)}});
    EXPECT_EQ((Vec3{end_game::kBaseLineX, edge_y(), 0}), state.scene.balls[0].state.r)
        << "what rounding takes out of the region is put back";
    EXPECT_FALSE(check(state.scene));
    EXPECT_EQ(0U, state.shots);
    EXPECT_EQ(Seat{0}, state.turn);
}

TEST(EndGame, PlacingTheCueBallIsNoTurnAndNoShot) {
    const Turn turn = kRules.play(new_game(), Place{{end_game::kBaseLineX, 0.2}});
    EXPECT_FALSE(turn.ruling);
    EXPECT_FALSE(turn.shot);
    GameState expected = new_game();
    expected.scene.balls[0].state.r.y = 0.2;
    EXPECT_EQ(expected, turn.state) << "nothing else has changed";
}

TEST(EndGame, PlacesOffTheBaseLineOrBeyondTheRailsAreRefused) {
    for (const Vec2 place :
         {Vec2{end_game::kBaseLineX + 0.01, 0}, Vec2{0, 0}, Vec2{end_game::kBaseLineX + 1.1e-6, 0},
          Vec2{end_game::kBaseLineX, edge_y() + 1.1e-6}, Vec2{end_game::kBaseLineX, -1},
          Vec2{kNan, 0}, Vec2{end_game::kBaseLineX, kNan}}) {
        EXPECT_EQ((IllegalMove{Illegal::kOutOfRegion, "/position"}),
                  fault_of(new_game(), Place{place}));
    }
}

TEST(EndGame, NearestPlaceIsOnTheBaseLineAndAllowed) {
    const GameState state = new_game();
    for (const Vec2 wish : {Vec2{0, 0.1}, Vec2{-5, 9}, Vec2{3, -9}}) {
        const Vec2 place = nearest_place(kRules.legal(state).place.value(), wish);
        EXPECT_EQ(end_game::kBaseLineX, place.x);
        EXPECT_EQ(std::clamp(wish.y, -edge_y(), edge_y()), place.y);
        EXPECT_FALSE(fault_of(state, Place{place}));
    }
}

TEST(EndGame, CueBallStaysPutAfterTheFirstShot) {
    const GameState state = shoot(new_game(), {-1, 0}).state;
    ASSERT_FALSE(state.over);
    EXPECT_EQ((IllegalMove{Illegal::kNotOffered, ""}),
              fault_of(state, Place{{end_game::kBaseLineX, 0}}));
    EXPECT_FALSE(kRules.legal(state).place);
    EXPECT_EQ(GamePart{EndGamePart{false}}, state.part);
}

TEST(EndGame, AimPointsAtTheEightBall) {
    GameState state = new_game();
    EXPECT_EQ(0, kRules.legal(state).aim.y);
    EXPECT_GT(kRules.legal(state).aim.x, 0);
    state = played(state, Place{{end_game::kBaseLineX, 0.25}});
    EXPECT_EQ((Vec2{end_game::kFootSpotX - end_game::kBaseLineX, -0.25}), kRules.legal(state).aim);
}

TEST(EndGame, DirectionsThatAreZeroOrNotFiniteAreRefused) {
    const GameState state = new_game();
    for (const Vec2 bad : {Vec2{}, Vec2{-0.0, 0}, Vec2{kNan, 1}, Vec2{1, kNan},
                           Vec2{std::numeric_limits<double>::infinity(), 0}})
        EXPECT_EQ((IllegalMove{Illegal::kBadDirection, "/strike/direction"}),
                  fault_of(state, Shoot{towards(bad)}));
    EXPECT_FALSE(fault_of(state, Shoot{towards({5e-324, 0})}));
    EXPECT_FALSE(fault_of(state, Shoot{towards({1e300, -1e300})}));
}

TEST(EndGame, EveryShotHasTheGamesSpeedAndHitsTheMiddle) {
    const GameState state = new_game();
    const StrokeBounds bounds = kRules.legal(state).shoot.value();
    EXPECT_EQ(
        (StrokeBounds{end_game::kShotSpeed, end_game::kShotSpeed, end_game::kShotSpeed, 0, 0}),
        bounds);
    Stroke stroke = towards({1, 0.5});
    EXPECT_EQ(end_game::kShotSpeed,
              std::get<Shoot>(completed(kRules.legal(state), Shoot{stroke})).strike.speed);
    stroke.speed = end_game::kShotSpeed;
    EXPECT_FALSE(fault_of(state, Shoot{stroke}));
    for (const double speed : {0.0, std::nextafter(end_game::kShotSpeed, 3), kNan}) {
        stroke.speed = speed;
        EXPECT_EQ((IllegalMove{Illegal::kOutOfBounds, "/strike/speed"}),
                  fault_of(state, Shoot{stroke}));
    }
    for (const Vec2 offset : {Vec2{1e-9, 0}, Vec2{0, -0.5}, Vec2{kNan, 0}}) {
        stroke = towards({1, 0.5});
        stroke.offset = offset;
        EXPECT_EQ((IllegalMove{Illegal::kOutOfBounds, "/strike/offset"}),
                  fault_of(state, Shoot{stroke}));
    }
    for (const double elevation : {1e-9, -1e-9, kNan}) {
        stroke = towards({1, 0.5});
        stroke.elevation = elevation;
        EXPECT_EQ((IllegalMove{Illegal::kOutOfBounds, "/strike/elevation"}),
                  fault_of(state, Shoot{stroke}));
    }
}

TEST(EndGame, TimeRunDownPassesTheTurnAndLeavesTheBalls) {
    for (const GameState& state : {new_game(), shoot(new_game(), {-1, 0}).state}) {
        const Turn turn = kRules.play(state, TimeOut{});
        EXPECT_EQ((Ruling{Verdict::kTimedOut, state.turn, opponent(state.turn), {}, 0}),
                  turn.ruling);
        GameState expected = state;
        expected.turn = opponent(state.turn);
        EXPECT_EQ(expected, turn.state) << "the cue ball stays in hand if it was";
        EXPECT_FALSE(turn.shot);
    }
}

TEST(EndGame, SeatThatConcedesLosesInItsTurnOrNot) {
    for (const Seat seat : kSeats) {
        const Turn turn = concede(new_game(), seat);
        EXPECT_EQ((Ruling{Verdict::kConceded, seat, opponent(seat), opponent(seat), 0}),
                  turn.ruling);
        EXPECT_TRUE(turn.state.over);
        EXPECT_EQ(opponent(seat), turn.state.winner);
        EXPECT_EQ(new_game().scene, turn.state.scene);
        EXPECT_EQ(Illegal::kNotOffered, refused(turn.state, Shoot{}));
        EXPECT_EQ(Illegal::kNotOffered, refused(turn.state, Place{{end_game::kBaseLineX, 0}}));
    }
}

TEST(EndGame, ShotThatSinksNothingPassesTheTurn) {
    const PlayedShot outcome = shoot(new_game(), {-1, 0});
    EXPECT_EQ(Verdict::kTurnPasses, outcome.ruling.verdict);
    EXPECT_EQ(Seat{0}, outcome.ruling.shooter);
    EXPECT_EQ(Seat{1}, outcome.ruling.next);
    EXPECT_FALSE(outcome.ruling.winner);
    EXPECT_EQ(outcome.trace.duration, outcome.ruling.decided_at);
    EXPECT_EQ(Seat{1}, outcome.state.turn);
    EXPECT_EQ(1U, outcome.state.shots);
    EXPECT_FALSE(outcome.state.scene.strike) << "a state between shots holds no strike";
    EXPECT_FALSE(check(outcome.state.scene));
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(outcome.trace.balls[i].state, outcome.state.scene.balls[i].state);
}

TEST(EndGame, EightBallDownWinsOnceEverythingIsAtRest) {
    const PlayedShot outcome =
        find_shot([](const PlayedShot& shot) { return shot.ruling.verdict == Verdict::kWon; });
    EXPECT_EQ(Seat{0}, outcome.ruling.winner);
    EXPECT_EQ(outcome.trace.duration, outcome.ruling.decided_at);
    EXPECT_GE(outcome.ruling.decided_at, time_pocketed(outcome, 1).value());
    EXPECT_TRUE(outcome.state.over);
    EXPECT_EQ(Seat{0}, outcome.state.winner);
    EXPECT_EQ(Seat{0}, outcome.state.turn) << "who shot last";
    ASSERT_EQ(1U, outcome.state.scene.balls.size());
    EXPECT_EQ("cue", outcome.state.scene.balls[outcome.state.cue_ball.value].id);
    EXPECT_EQ(Illegal::kNotOffered, refused(outcome.state, Shoot{towards({1, 0})}));
    EXPECT_FALSE(kRules.legal(outcome.state).shoot);
    EXPECT_FALSE(kRules.legal(outcome.state).place);
    EXPECT_NE((Vec2{}), kRules.legal(outcome.state).aim);
}

TEST(EndGame, CueBallDownLosesAtOnce) {
    const PlayedShot outcome = find_shot([](const PlayedShot& shot) {
        return shot.ruling.verdict == Verdict::kScratch && !time_pocketed(shot, 1);
    });
    EXPECT_EQ(Seat{1}, outcome.ruling.winner);
    EXPECT_EQ(time_pocketed(outcome, 0), outcome.ruling.decided_at);
    EXPECT_TRUE(outcome.state.over);
    EXPECT_EQ(2U, outcome.state.scene.balls.size()) << "the cue ball is back on the base line";
    EXPECT_EQ(end_game::kBaseLineX, outcome.state.scene.balls[0].state.r.x);
    EXPECT_FALSE(check(outcome.state.scene));
}

TEST(EndGame, CueBallDownLosesEvenIfTheEightBallIsDownAlready) {
    const PlayedShot outcome = find_shot([](const PlayedShot& shot) {
        const auto eight = time_pocketed(shot, 1);
        const auto cue = time_pocketed(shot, 0);
        return eight && cue && *eight < *cue;
    });
    EXPECT_EQ(Verdict::kScratch, outcome.ruling.verdict);
    EXPECT_EQ(Seat{1}, outcome.ruling.winner);
    EXPECT_EQ(time_pocketed(outcome, 0), outcome.ruling.decided_at);
}

TEST(EndGame, CueBallDownLosesEvenIfTheEightBallGoesDownLater) {
    const PlayedShot outcome = find_shot([](const PlayedShot& shot) {
        const auto eight = time_pocketed(shot, 1);
        const auto cue = time_pocketed(shot, 0);
        return eight && cue && *cue < *eight;
    });
    EXPECT_EQ(Verdict::kScratch, outcome.ruling.verdict);
    EXPECT_EQ(time_pocketed(outcome, 0), outcome.ruling.decided_at);
    EXPECT_EQ(1U, outcome.state.scene.balls.size());
}

TEST(EndGame, OutcomeHoldsTheSceneThatGivesTheTraceAgain) {
    const PlayedShot outcome = shoot(new_game(), {3, 0.2});
    EXPECT_FALSE(check(outcome.scene));
    const ShotTrace again = simulate(outcome.scene, kPlayoutHz);
    EXPECT_EQ(outcome.trace.hash, again.hash);
    EXPECT_EQ(outcome.trace.samples, again.samples);
    EXPECT_EQ(kPlayoutHz, outcome.trace.sample_hz);
}

TEST(EndGame, GamesOfRandomShotsEndAndEveryStateIsASceneThatPassesItsCheck) {
    testing::Random random(12);
    for (int game = 0; game < 100; ++game) {
        GameState state = new_game();
        while (!state.over) {
            ASSERT_LT(state.shots, 1000U);
            const Seat shooter = state.turn;
            const PlayedShot outcome = shoot(state, random.direction());
            ASSERT_EQ(Outcome::kRest, outcome.trace.outcome);
            ASSERT_EQ(shooter, outcome.ruling.shooter);
            ASSERT_EQ(outcome.state.over, outcome.ruling.winner.has_value());
            state = outcome.state;
            ASSERT_FALSE(check(state.scene));
        }
    }
}

/// A game in which balls can fly, on cloth.
GameState flying_game() {
    GameState state = new_game();
    state.scene.effects = {};
    state.scene.effects.sliding = SlidingSpec{};
    state.scene.effects.rolling = RollingSpec{};
    state.scene.effects.airborne = AirborneSpec{};
    state.scene.solver.kind = SolverKind::kEvent;
    return state;
}

TEST(EndGame, ShotThatEndsAtALimitLeavesTheBallsAtRestWhereTheyWere) {
    GameState state = new_game();
    for (const Limits limits : {Limits{0.75, 100000}, Limits{600, 3}}) {
        state.scene.limits = limits;
        const PlayedShot outcome = shoot(state, {1, 0.01});
        ASSERT_NE(Outcome::kRest, outcome.trace.outcome);
        EXPECT_EQ(Verdict::kTurnPasses, outcome.ruling.verdict);
        EXPECT_EQ(outcome.trace.duration, outcome.ruling.decided_at);
        for (std::size_t i = 0; i < 2; ++i) {
            const BallState& left = outcome.state.scene.balls[i].state;
            EXPECT_NE(Vec3{}, outcome.trace.balls[i].state.v);
            EXPECT_EQ(outcome.trace.balls[i].state.r, left.r);
            EXPECT_EQ(Vec3{}, left.v);
        }
        EXPECT_FALSE(check(outcome.state.scene));
    }
}

TEST(EndGame, SpinThatNothingTakesAwayEndsWithTheShot) {
    GameState state = flying_game();
    state.scene.effects.ball_ball = {BallBallModel::kFriction, 0.95, 0.05, std::nullopt, 1e-4};
    const PlayedShot outcome = shoot(state, {1, 0.03});
    EXPECT_NE(0, outcome.trace.balls[0].state.w.z);
    EXPECT_EQ(Vec3{}, outcome.state.scene.balls[0].state.w);
}

TEST(EndGame, CueBallOverARailIsAScratch) {
    GameState state = flying_game();
    state.scene.balls[0].state = {{0.6, 0.2, 0.3}, {}, {}};
    const PlayedShot outcome = shoot(state, {1, 0});
    ASSERT_EQ(Motion::kOffTable, outcome.trace.balls[0].motion);
    EXPECT_EQ(Verdict::kScratch, outcome.ruling.verdict);
    EXPECT_EQ(Seat{1}, outcome.ruling.winner);
    EXPECT_LT(outcome.ruling.decided_at, outcome.trace.duration + 1e-12);
    EXPECT_EQ((Vec3{end_game::kBaseLineX, 0, 0}), outcome.state.scene.balls[0].state.r);
}

TEST(EndGame, EightBallOverARailReturnsToItsSpotAndTheTurnPasses) {
    GameState state = flying_game();
    state.scene.balls[1].state = {{0.6, 0.2, 0.3}, {2, 0, 0}, {}};
    const PlayedShot outcome = shoot(state, {-1, 0.02});
    ASSERT_EQ(Motion::kOffTable, outcome.trace.balls[1].motion);
    EXPECT_EQ(Verdict::kTurnPasses, outcome.ruling.verdict);
    EXPECT_EQ((Vec3{end_game::kFootSpotX, 0, 0}), outcome.state.scene.balls[1].state.r);
    EXPECT_FALSE(check(outcome.state.scene));
}

TEST(EndGame, CentreHitsLeaveNoBallInTheAir) {
    GameState state = flying_game();
    state.scene.effects.ball_ball = {BallBallModel::kFriction, 0.9, 0.2, std::nullopt, 1e-4};
    state.scene.effects.rail = {RailModel::kMathavan2010, 0.85, 0.3, 0.036576};
    testing::Random random(16);
    for (int shot = 0; shot < 100; ++shot) {
        const PlayedShot outcome = shoot(state, random.direction());
        for (const ShotEvent& event : outcome.trace.events) {
            EXPECT_NE(EventKind::kBounce, event.kind);
            EXPECT_EQ(0, event.after[0].r.z);
            EXPECT_EQ(0, event.after[0].v.z);
        }
    }
}

TEST(Rulesets, AreFoundByName) {
    EXPECT_EQ(&kEndGameRules, find_ruleset("end_game"));
    EXPECT_EQ(nullptr, find_ruleset("snooker"));
    EXPECT_EQ(nullptr, find_ruleset(""));
    EXPECT_EQ(1U, all_rulesets().size());
}

}  // namespace
}  // namespace poolhall
