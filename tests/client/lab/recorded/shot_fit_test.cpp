#include "client/lab/recorded/shot_fit.hpp"

#include "client/lab/recorded/constants_fit.hpp"
#include "client/lab/recorded/minimise.hpp"
#include "shared/analysis/paths.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace poolhall::lab {
namespace {

/// What make_shots.py simulated with.
TableConstants true_constants() {
    TableConstants constants;
    constants.mu_slide = 0.2;
    constants.mu_roll = 0.0045;
    constants.mu_spin = 0.006;
    constants.ball_ball.model = BallBallModel::kFriction;
    constants.ball_ball.e = 0.96;
    constants.ball_ball.mu = 0.06;
    constants.rail = {RailModel::kHan2005, 0.86, 0.25, 0.0369};
    return constants;
}

std::vector<RecordedShot> made_up_shots() {
    auto shots = read_recording(POOLHALL_MADE_UP_SHOTS);
    EXPECT_TRUE(shots) << shots.error();
    return std::move(*shots);
}

constexpr FitPlan kPlan{200, 24, 2};

TEST(ShotMarks, TellWhereTheCueBallGoesAtFirst) {
    const ShotMarks marks = marks_of(made_up_shots()[0]);
    EXPECT_NEAR(0, cross(marks.direction, normalized(Vec2{1.6, 0.52})), 0.005);
    EXPECT_NEAR(3.2, marks.speed, 0.2);
    EXPECT_EQ(marks.end, marks.horizons.back());
}

TEST(ShotMarks, TellWhenTheCueBallMeetsItsThirdRail) {
    const auto shots = made_up_shots();
    EXPECT_NEAR(4.04, marks_of(shots[2]).third_rail, 0.03);
    const ShotMarks two_rails = marks_of(shots[0]);
    EXPECT_EQ(two_rails.end, two_rails.third_rail);
}

TEST(BallCourses, AreWhereTheSamplesOfTheTraceAre) {
    Scene scene = scene_of(made_up_shots()[0], true_constants());
    scene.strike->direction = Vec2{1.6, 0.52};
    scene.strike->speed = 3.2;
    const ShotTrace trace = simulate(scene, 37);
    BallCourses courses;
    courses.set(scene, trace);
    for (std::size_t ball = 0; ball < scene.balls.size(); ++ball) {
        for (std::size_t k = 0; k + 1 < trace.sample_count(); ++k) {
            const double t = static_cast<double>(k) / 37;
            auto stretch = courses.of(ball).begin();
            while (stretch + 1 != courses.of(ball).end() && (stretch + 1)->t <= t)
                ++stretch;
            EXPECT_LT(norm(place_on(*stretch, t) - xy(trace.sample(k, ball))), 1e-9)
                << ball << " at " << t;
        }
    }
}

TEST(ShotFit, FindsTheShotsThatWereMadeWithTheSameConstants) {
    std::size_t found = 0;
    for (const RecordedShot& shot : made_up_shots()) {
        ShotFit fit(shot, true_constants());
        const auto best = fit.from_scratch(kPlan, 1).front();
        const ShotFit::Distances off = fit.distances(best);
        EXPECT_LT(off.to_third_rail, 0.02) << shot.id;
        if (off.whole < 0.02) ++found;
    }
    EXPECT_GE(found, 3U);
}

TEST(ShotFit, IsTheSameForAnyNumberOfThreads) {
    std::ostringstream bar;
    Progress progress(bar, false);
    const auto one = fit_shots(made_up_shots(), true_constants(), {50, 8, 1}, 1, progress);
    const auto three = fit_shots(made_up_shots(), true_constants(), {50, 8, 1}, 3, progress);
    ASSERT_TRUE(one && three);
    EXPECT_EQ(one->whole.median, three->whole.median);
    EXPECT_EQ(one->to_third_rail.p75, three->to_third_rail.p75);
}

TEST(ConstantsFit, ComesNearerToTheShotsThanWhatItBeganWith) {
    std::ostringstream bar;
    Progress progress(bar, false);
    TableConstants start = true_constants();
    start.mu_roll = 0.0055;
    start.rail.e = 0.8;
    TableFitPlan plan;
    plan.first = {60, 10, 1};
    plan.evaluations = 50;
    plan.rounds = 1;
    const auto shots = made_up_shots();
    const auto constants = fit_constants(shots, start, plan, progress);
    ASSERT_TRUE(constants);
    const auto before = fit_shots(shots, start, kPlan, 1, progress);
    const auto after = fit_shots(shots, *constants, kPlan, 1, progress);
    ASSERT_TRUE(before && after);
    EXPECT_LT(after->whole.median, 0.9 * before->whole.median);
}

TEST(Minimise, FindsTheLeastOfASmoothFunctionWithinItsBounds) {
    const auto value = [](const double* at) {
        return (at[0] - 1) * (at[0] - 1) + 10 * (at[1] + 2) * (at[1] + 2);
    };
    for (const SearchMethod method : {SearchMethod::kQuadratic, SearchMethod::kSimplex}) {
        const Minimum found = minimise(method, {{0, 0}, {-5, -1}, {5, 5}, {0.5, 0.5}}, 300, value);
        EXPECT_NEAR(1, found.at[0], 0.05);
        EXPECT_NEAR(-1, found.at[1], 1e-3);
    }
}

}  // namespace
}  // namespace poolhall::lab
