#include "client/lab/corpora/bench_scenes.hpp"

#include "client/lab/corpora/scene_makers.hpp"

#include <cmath>
#include <limits>

namespace poolhall::lab {

namespace {

constexpr double kDiameter = 2 * BallSpec{}.radius;
constexpr double kHalfRootThree = 0.86602540378443865;

Scene on_cloth(Scene scene) {
    scene.effects = cloth_effects();
    scene.solver.kind = SolverKind::kEvent;
    return scene;
}

/// From the head string, a little off the middle, so that no two hits are the same by symmetry.
Scene broken(std::vector<Vec2> rack) {
    rack.insert(rack.begin(), Vec2{-0.635, 0.01});
    Scene scene = on_cloth(scene_of(rack));
    scene.strike = Strike{BallIndex{0}, {1.27, -0.01}, 8};
    return scene;
}

}  // namespace

void aim_at_object(Scene& scene, double aside) {
    const Vec2 line = xy(scene.balls[1].state.r) - xy(scene.balls[0].state.r);
    const double slope = aside * kDiameter / norm(line);
    scene.strike->direction = line + slope * Vec2{-line.y, line.x};
}

std::vector<Scene> two_ball_shots(std::size_t count) {
    Random random(1);
    std::vector<Scene> shots;
    while (shots.size() < count) {
        Scene scene = on_cloth(random_scene(random, 2, random.uniform(1, 5)));
        aim_at_object(scene, random.uniform(-0.95, 0.95));
        shots.push_back(scene);
    }
    return shots;
}

Scene nine_ball_break() {
    constexpr double kPitch = kDiameter + 1e-4;
    std::vector<Vec2> rack;
    for (int row = 0; row < 5; ++row) {
        const int balls = row < 3 ? row + 1 : 5 - row;
        for (int i = 0; i < balls; ++i)
            rack.push_back(
                {0.635 + row * kHalfRootThree * kPitch, (i - (balls - 1) / 2.0) * kPitch});
    }
    return broken(rack);
}

Scene fifteen_ball_break(double gap) {
    const double pitch = kDiameter + gap;
    std::vector<Vec2> rack;
    for (int row = 0; row < 5; ++row) {
        for (int i = 0; i <= row; ++i)
            rack.push_back({0.635 + row * kHalfRootThree * pitch, (i - row / 2.0) * pitch});
    }
    return broken(rack);
}

Scene crowd(std::size_t count) {
    Random random(2);
    const auto columns =
        static_cast<std::size_t>(std::ceil(std::sqrt(2.0 * static_cast<double>(count))));
    const std::size_t rows = (count + columns - 1) / columns;
    const double cell = std::sqrt(2.54 * 1.27 / 16);
    std::vector<Vec2> places;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t column = i % columns;
        const std::size_t row = i / columns;
        const Vec2 centre{(static_cast<double>(column) + 0.5) - static_cast<double>(columns) / 2,
                          (static_cast<double>(row) + 0.5) - static_cast<double>(rows) / 2};
        places.push_back(cell * centre + 0.15 * random.direction());
    }
    Scene scene = on_cloth(scene_of(places));
    scene.table.length = cell * static_cast<double>(columns);
    scene.table.width = cell * static_cast<double>(rows);
    for (SceneBall& ball : scene.balls)
        set_xy(ball.state.v, 2 * random.direction());
    return scene;
}

Scene slow_chase(double gap, double surplus) {
    Scene scene = on_cloth(scene_of({{-1, 0}, {-1 + kDiameter + gap, 0}}));
    const double radius = scene.ball.radius;
    for (std::size_t i = 0; i < 2; ++i) {
        BallState& state = scene.balls[i].state;
        state.v.x = i == 0 ? 1 + surplus : 1;
        state.w.y = state.v.x / radius;
    }
    return scene;
}

Scene graze(int ulps, int quarter, double way) {
    double offset = kDiameter;
    const double towards = ulps < 0 ? 0 : std::numeric_limits<double>::infinity();
    for (int i = 0; i < std::abs(ulps); ++i)
        offset = std::nextafter(offset, towards);
    const auto turned = [quarter](Vec2 a) {
        if (quarter >= 2) a = {-a.y, a.x};
        return quarter % 2 == 1 ? Vec2{-a.x, -a.y} : a;
    };
    Scene scene = scene_of({turned({-way, 0}), turned({0, offset})});
    set_xy(scene.balls[0].state.v, turned({3, 0}));
    scene.table.rails = false;
    scene.limits.time = way;
    return scene;
}

}  // namespace poolhall::lab
