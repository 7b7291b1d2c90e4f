#include "server/room/playout.hpp"

#include "protocol/codec/codec.hpp"
#include "protocol/limits.hpp"
#include "shared/game/end_game.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using protocol::Frame;

/// The first shot of a game.
Playout playout(Vec2 direction = {1, 0.01}, const GameSettings& settings = {}) {
    const Match match({&kEndGameRules, Seat{0}, {settings}});
    return {match.play(Seat{0}, Shoot{Stroke{direction, {}}}, 0), {}};
}

std::vector<double> times(const std::vector<ShotEvent>& events) {
    std::vector<double> times;
    for (const ShotEvent& event : events)
        times.push_back(event.t);
    return times;
}

TEST(Playout, EveryEventFallsInTheFrameOfItsTick) {
    Playout playout = server::playout();
    std::vector<ShotEvent> seen;
    for (std::uint32_t tick = 1; tick <= playout.last_tick(); ++tick) {
        const Frame frame = playout.advance(tick);
        for (const ShotEvent& event : frame.events)
            EXPECT_LE(event.t, tick / kPlayoutHz);
        seen.insert(seen.end(), frame.events.begin(), frame.events.end());
    }
    EXPECT_TRUE(playout.finished());
    EXPECT_EQ(times(seen), times(playout.trace().events));
}

/// Plays a shot of real pool and shows it tick by tick.
void expect_whole_playout(const SolverSpec& solver) {
    Playout playout = server::playout({1, 0.03}, poolhall::test::pool_settings(solver));
    const ShotTrace& trace = playout.trace();
    std::vector<Vec2> shown{xy(trace.sample(0, 0)), xy(trace.sample(0, 1))};
    std::vector<double> seen;
    for (std::uint32_t tick = 1; tick <= playout.last_tick(); ++tick) {
        const Frame frame = playout.advance(tick);
        for (const Frame::Ball& ball : frame.balls)
            shown[ball.ball.value] = ball.r;
        for (const ShotEvent& event : frame.events) {
            EXPECT_LE(event.t, tick / kPlayoutHz);
            EXPECT_TRUE(tick == 1 || event.t > (tick - 1) / kPlayoutHz);
            seen.push_back(event.t);
        }
    }
    EXPECT_TRUE(playout.finished());
    EXPECT_EQ(seen, times(trace.events));
    EXPECT_GE(playout.last_tick() / kPlayoutHz, trace.duration);
    EXPECT_LT((playout.last_tick() - 1) / kPlayoutHz, trace.duration);
    for (std::size_t ball = 0; ball < shown.size(); ++ball)
        EXPECT_EQ(shown[ball], xy(trace.balls[ball].state.r))
            << "the last frame is the final state";
}

TEST(Playout, ShowsTheTraceOfEverySolverAtItsOwnRate) {
    for (const SolverSpec& solver : poolhall::test::kPlayableSolvers) {
        SCOPED_TRACE(std::string(name(solver.kind)) + " " + std::to_string(solver.hz));
        expect_whole_playout(solver);
    }
}

TEST(Playout, ShotThatIsOverAtOnceIsShownForATick) {
    GameSettings settings = poolhall::test::pool_settings();
    settings.effects->rail = {RailModel::kRestitution, 0, 0.2, 0.036576};
    GameState state = new_game(kEndGameRules, Seat{0}, settings);
    const double edge = inset(state.scene.table, state.scene.ball.radius).x;
    set_xy(state.scene.balls[0].state.r, {-edge, 0.2});
    const Move move = completed(kEndGameRules.legal(state), Shoot{Stroke{{-1, 0}, {}}});
    const Match match({&kEndGameRules, Seat{0}, {settings}});
    Playout playout(match.recorded({Seat{0}, move}, kEndGameRules.play(state, move)), {});
    ASSERT_EQ(playout.trace().duration, 0);
    ASSERT_EQ(playout.last_tick(), 1U);
    EXPECT_EQ(playout.live().balls.size(), 2U);
    const Frame frame = playout.advance(1);
    EXPECT_EQ(times(frame.events), times(playout.trace().events));
    EXPECT_TRUE(frame.balls.empty());
    EXPECT_TRUE(playout.finished());
}

TEST(Playout, AllThatAShotWithSettingsMayHoldFitsIntoAFrame) {
    constexpr double kLong = -1.2345678901234567e-300;
    constexpr Vec3 kLongest{kLong, kLong, kLong};
    ShotEvent event;
    event.kind = EventKind::kBallBall;
    event.ball_count = 2;
    event.t = -kLong;
    event.before = {BallState{kLongest, kLongest, kLongest},
                    BallState{kLongest, kLongest, kLongest}};
    event.after = event.before;
    const Frame frame{1, 1, {}, std::vector<ShotEvent>(kGameLimits.events, event)};
    EXPECT_LT(encode(frame, protocol::Encoding::kJson).size(), protocol::kMaxServerMessageBytes);
}

TEST(Playout, FrameHasOnlyTheBallsThatMoved) {
    Playout playout = server::playout();
    const Frame first = playout.advance(1);
    ASSERT_EQ(first.balls.size(), 1U) << "the 8-ball has not been hit yet";
    EXPECT_EQ(first.balls.front().r, xy(playout.trace().sample(1, first.balls.front().ball.value)));
}

TEST(Playout, SkippedTicksLoseNoEvent) {
    Playout playout = server::playout();
    const Frame all = playout.advance(playout.last_tick());
    EXPECT_EQ(all.events.size(), playout.trace().events.size());
}

TEST(Playout, LateComerSeesWhereTheBallsAre) {
    Playout playout = server::playout();
    (void)playout.advance(7);
    const protocol::LiveShot live = playout.live();
    EXPECT_EQ(live.tick, 7U);
    ASSERT_EQ(live.balls.size(), 2U);
    EXPECT_EQ(live.balls[0], xy(playout.trace().sample(7, 0)));
}

}  // namespace
}  // namespace poolhall::server
