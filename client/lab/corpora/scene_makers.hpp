#pragma once

#include "client/lab/corpora/random.hpp"
#include "shared/physics/scene/scene.hpp"

#include <algorithm>
#include <string>
#include <vector>

// Scenes for corpora, benchmarks and tests.
namespace poolhall::lab {

/// Balls at the given places (m), at rest, on the default table without pockets and without any
/// effect. Their ids are "0", "1", ...
[[nodiscard]] inline Scene scene_of(const std::vector<Vec2>& places) {
    Scene scene;
    for (std::size_t i = 0; i < places.size(); ++i) {
        SceneBall ball{std::to_string(i), {}};
        set_xy(ball.state.r, places[i]);
        scene.balls.push_back(ball);
    }
    return scene;
}

/// One ball at r with velocity v.
[[nodiscard]] inline Scene scene_of(Vec2 r, Vec2 v) {
    Scene scene = scene_of({r});
    set_xy(scene.balls[0].state.v, v);
    return scene;
}

/// `count` balls at random places that do not overlap, under linear drag, the first struck at
/// `speed` m/s.
[[nodiscard]] inline Scene random_scene(Random& random, std::size_t count, double speed) {
    std::vector<Vec2> places;
    const Vec2 edge = inset(Table{}, BallSpec{}.radius);
    while (places.size() < count) {
        const double x = random.uniform(-edge.x, edge.x);
        const Vec2 place{x, random.uniform(-edge.y, edge.y)};
        const bool free = std::all_of(places.begin(), places.end(), [&](Vec2 other) {
            return norm(place - other) > 2 * BallSpec{}.radius;
        });
        if (free) places.push_back(place);
    }
    Scene scene = scene_of(places);
    scene.effects.linear_drag = LinearDragSpec{};
    scene.strike = Strike{BallIndex{0}, random.direction(), speed};
    return scene;
}

/// A rack of `rows` rows behind the foot spot, under linear drag, its apex struck head-on by ball
/// 0; neighbours are `gap` m apart.
[[nodiscard]] inline Scene break_scene(int rows, double gap, double speed) {
    constexpr double kHalfRootThree = 0.86602540378443865;
    const double pitch = 2 * BallSpec{}.radius + gap;
    std::vector<Vec2> places{{-0.6, 0}};
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i <= row; ++i)
            places.push_back({0.6 + row * kHalfRootThree * pitch, (i - row / 2.0) * pitch});
    }
    Scene scene = scene_of(places);
    scene.effects.linear_drag = LinearDragSpec{};
    scene.strike = Strike{BallIndex{0}, {1, 0}, speed};
    return scene;
}

/// Real cloth, balls and rails: sliding, rolling, spin decay, throw, rails after Han.
[[nodiscard]] inline Effects cloth_effects() {
    Effects effects;
    effects.sliding = SlidingSpec{};
    effects.rolling = RollingSpec{};
    effects.spin_decay = SpinDecaySpec{};
    effects.ball_ball.model = BallBallModel::kFriction;
    effects.rail = {.model = RailModel::kHan2005, .e = 0.85};
    return effects;
}

}  // namespace poolhall::lab
