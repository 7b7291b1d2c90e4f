#pragma once

#include "shared/physics/scene.hpp"
#include "tests/shared/random.hpp"

#include <string>
#include <vector>

namespace poolhall::testing {

/// Balls at the given places, at rest, on the default table without pockets and without drag.
inline Scene scene_of(const std::vector<Vec2>& places) {
    Scene scene;
    for (std::size_t i = 0; i < places.size(); ++i) {
        SceneBall ball{std::to_string(i), {}};
        set_xy(ball.state.r, places[i]);
        scene.balls.push_back(ball);
    }
    return scene;
}

/// One ball at r with velocity v.
inline Scene scene_of(Vec2 r, Vec2 v) {
    Scene scene = scene_of({r});
    set_xy(scene.balls[0].state.v, v);
    return scene;
}

/// `count` balls at random places that do not overlap, the first struck at `speed` m/s.
inline Scene random_scene(Random& random, std::size_t count, double speed) {
    std::vector<Vec2> places;
    const Vec2 edge = inset(Table{}, BallSpec{}.radius);
    while (places.size() < count) {
        const Vec2 place{random.uniform(-edge.x, edge.x), random.uniform(-edge.y, edge.y)};
        bool free = true;
        for (const Vec2 other : places)
            free = free && norm(place - other) > 2 * BallSpec{}.radius;
        if (free) places.push_back(place);
    }
    Scene scene = scene_of(places);
    scene.effects.linear_drag = LinearDragSpec{};
    scene.strike = Strike{BallIndex{0}, random.direction(), speed};
    return scene;
}

/// A rack of `rows` rows behind the foot spot, its apex struck head-on by ball 0; neighbours are
/// `gap` m apart.
inline Scene break_scene(int rows, double gap, double speed) {
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

}  // namespace poolhall::testing
