#include "client/lab/recorded/table_constants.hpp"

#include <algorithm>

namespace poolhall::lab {

namespace {

/// Places are rounded to a millimetre, so that touching balls may overlap: they are parted.
void part_balls(Scene& scene) {
    const double least = 2 * scene.ball.radius;
    constexpr double kSpare = 1e-9;  // m
    for (SceneBall& a : scene.balls) {
        for (SceneBall& b : scene.balls) {
            const Vec2 way = xy(b.state.r) - xy(a.state.r);
            const double distance = norm(way);
            if (&a == &b || distance >= least || distance == 0) continue;
            const Vec2 half = ((least - distance) / 2 + kSpare) / distance * way;
            set_xy(a.state.r, xy(a.state.r) - half);
            set_xy(b.state.r, xy(b.state.r) + half);
        }
    }
}

}  // namespace

std::vector<FittedConstant> fitted_constants(const RailSpec& rail) {
    using C = TableConstants;
    std::vector<FittedConstant> all{
        {"mu_slide", [](C& c) { return &c.mu_slide; }, 0.08, 0.4, 0.03},
        {"mu_roll", [](C& c) { return &c.mu_roll; }, 0.003, 0.007, 0.0003},
        {"mu_spin", [](C& c) { return &c.mu_spin; }, 0, 0.04, -0.004},
        {"rail mu", [](C& c) { return &c.rail.mu; }, 0.02, 0.6, 0.06},
        {"nose height", [](C& c) { return &c.rail.nose_height; }, 0.033, 0.045, 0.001},
        {"ball e", [](C& c) { return &c.ball_ball.e; }, 0.85, 1, -0.02},
        {"ball mu", [](C& c) { return &c.ball_ball.mu; }, 0, 0.2, 0.02}};
    if (rail.e_by_speed) {
        all.push_back({"rail e", [](C& c) { return &c.rail.e_by_speed->e; }, 0.6, 1, -0.05});
        all.push_back(
            {"best speed", [](C& c) { return &c.rail.e_by_speed->best_speed; }, 0.5, 5, 0.5});
        all.push_back(
            {"softening", [](C& c) { return &c.rail.e_by_speed->softening; }, 0, 0.5, 0.05});
    } else {
        all.push_back({"rail e", [](C& c) { return &c.rail.e; }, 0.6, 1, 0.05});
    }
    return all;
}

Scene scene_of(const RecordedShot& shot, const TableConstants& constants) {
    Scene scene;
    scene.table.length = kCaromLength;
    scene.table.width = kCaromWidth;
    scene.ball = kRecordedBall;
    scene.effects.sliding = SlidingSpec{constants.mu_slide};
    scene.effects.rolling = RollingSpec{constants.mu_roll};
    scene.effects.spin_decay = SpinDecaySpec{constants.mu_spin};
    scene.effects.ball_ball = constants.ball_ball;
    scene.effects.rail = constants.rail;
    scene.solver.kind = SolverKind::kEvent;
    constexpr std::uint32_t kMostEvents = 400;  // real shots have fifty
    scene.limits.events = kMostEvents;
    const Vec2 edge = inset(scene.table, scene.ball.radius);
    for (const RecordedTrack& track : shot.tracks) {
        SceneBall& ball = scene.balls.emplace_back();
        ball.id = std::to_string(scene.balls.size());
        const Vec2 place = track.r.front();
        set_xy(ball.state.r,
               {std::clamp(place.x, -edge.x, edge.x), std::clamp(place.y, -edge.y, edge.y)});
    }
    part_balls(scene);
    scene.strike = Strike{BallIndex{static_cast<std::uint8_t>(shot.cue)}, {1, 0}, 1};
    return scene;
}

}  // namespace poolhall::lab
