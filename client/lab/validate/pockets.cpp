#include "client/lab/validate/cases.hpp"
#include "client/lab/validate/tables.hpp"
#include "shared/physics/simulate.hpp"
#include "shared/table/pool_table.hpp"

#include <cmath>
#include <string>

namespace poolhall::lab {

namespace {

// TP 3.5 to 3.8 (second hand): a corner pocket, approached along the rail, that is at 43 degrees to
// the line into it.
constexpr double kSlowWidth = 86;     ///< mm of parallel lines that go in
constexpr double kMostShift = 15;     ///< mm, of the middle of them between slow and fast
constexpr double kFromBisector = 43;  ///< degrees
constexpr double kSlow = 0.7;         ///< m/s; just enough for the way
constexpr double kMedium = 2;
constexpr double kFast = 4;

struct Opening {
    double width = 0;   ///< mm
    double middle = 0;  ///< mm, to the left of the line to the pocket
};

/// A rolling ball towards the NE pocket, `offset` m to the left of the line to its hole.
Scene shot_at(double offset, double speed) {
    Scene scene;
    scene.table.pockets = PocketModel::kPool;
    scene.effects.sliding = SlidingSpec{};
    scene.effects.rolling = RollingSpec{};
    scene.effects.spin_decay = SpinDecaySpec{};
    scene.effects.rail.model = RailModel::kHan2005;
    scene.effects.rail.e = 0.85;
    scene.solver.kind = SolverKind::kEvent;
    const double angle = (45 - kFromBisector) * kDegree;
    const Vec2 way{std::cos(angle), std::sin(angle)};
    const Vec2 left{-way.y, way.x};
    const PoolTable table(scene.table);
    const Vec2 hole = table.holes()[static_cast<std::size_t>(Pocket::kNorthEast)].centre;
    constexpr double kWay = 1;  // m
    const Vec2 from = hole - kWay * way + offset * left;
    const double radius = scene.ball.radius;
    scene.balls = {{"1",
                    {{from.x, from.y, 0},
                     {speed * way.x, speed * way.y, 0},
                     {-speed * way.y / radius, speed * way.x / radius, 0}}}};
    return scene;
}

/// Whether it falls without having met the far end of the table.
bool falls(double offset, double speed) {
    Scene scene = shot_at(offset, speed);
    scene.limits.time = 4 / speed;
    const FinalBall ball = simulate(scene).balls[0];
    return ball.motion == Motion::kPocketed && ball.pocket == Pocket::kNorthEast;
}

Opening opening_at(double speed) {
    constexpr double kStep = 0.25;  // mm
    // The rail itself ends the sweep on the left.
    const double rail = Scene{}.table.width / 2 - BallSpec{}.radius;
    double sum = 0;
    int count = 0;
    for (double offset = -120; offset <= 120; offset += kStep) {
        const Scene scene = shot_at(offset / 1000, speed);
        if (scene.balls[0].state.r.y >= rail || !falls(offset / 1000, speed)) continue;
        sum += offset;
        ++count;
    }
    return {kStep * count, count > 0 ? sum / count : 0};
}

}  // namespace

std::vector<MeasuredTable> pocket_tables() {
    const Opening slow = opening_at(kSlow);
    const Opening medium = opening_at(kMedium);
    const Opening fast = opening_at(kFast);
    MeasuredTable table{.name = "corner_pocket",
                        .title = "Corner pocket, along the rail: what goes in",
                        .unit = "mm",
                        .source = "TP 3.5 to 3.8 (Alciatore, second hand)",
                        .accuracy = "computed there from the pocket's geometry: some mm",
                        .digits = 1,
                        .reach = 10,
                        .models = {"mouth by default"}};
    table.rows = {{"width at 0.7 m/s", kSlowWidth, false, {slow.width}},
                  {"width at 2 m/s: less", {0, slow.width}, false, {medium.width}},
                  {"width at 4 m/s: less again", {0, medium.width}, false, {fast.width}},
                  {"its middle moves, slow to fast",
                   {0, kMostShift},
                   false,
                   {std::abs(fast.middle - slow.middle)}}};
    return {table};
}

}  // namespace poolhall::lab
