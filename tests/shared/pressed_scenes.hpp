#pragma once

#include "tests/shared/random.hpp"
#include "tests/shared/scenes.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace poolhall::testing {

/// Up to nine balls, each of which touches one before it or nearly does, the first in the open, at
/// a rail or in a corner.
inline std::vector<Vec2> cluster(Random& random) {
    constexpr double kDiameter = 2 * BallSpec{}.radius;
    const Vec2 edge = inset(Table{}, BallSpec{}.radius);
    const std::array starts{Vec2{}, Vec2{edge.x, random.uniform(-0.4, 0.4)}, edge};
    std::vector<Vec2> places{starts[random.below(3)]};
    for (int tries = 0; tries < 100 && places.size() < 9; ++tries) {
        const Vec2 beside = random.below(3) == 0 ? Vec2{-1, 0} : random.direction();
        const double gap = random.below(2) == 0 ? 0 : random.uniform(0, 1e-6);
        const Vec2 place = places[random.below(places.size())] + (kDiameter + gap) * beside;
        const bool free = std::all_of(places.begin(), places.end(),
                                      [&](Vec2 other) { return norm(place - other) >= kDiameter; });
        if (free && std::abs(place.x) <= edge.x && std::abs(place.y) <= edge.y)
            places.push_back(place);
    }
    return places;
}

/// Any models but rails that take the balls one by one.
inline void choose_models(Random& random, Effects& effects) {
    effects = lab::cloth_effects();
    effects.ball_ball.model = static_cast<BallBallModel>(random.below(3));
    effects.ball_ball.e = random.below(3) == 0 ? 0 : random.uniform(0.5, 1);
    effects.rail.model = static_cast<RailModel>(random.below(3));
    effects.rail.e = random.below(3) == 0 ? 0 : random.uniform(0.3, 1);
    if (random.below(4) == 0) effects.rolling.reset();
    if (random.below(6) == 0) effects.airborne = AirborneSpec{};
}

/// Balls that touch each other and the rails, and whose spins press them together: they meet again
/// and again within a tick.
inline Scene pressed_scene(Random& random) {
    Scene scene = scene_of(cluster(random));
    choose_models(random, scene.effects);
    if (random.below(3) == 0) scene.table.pockets = PocketModel::kPool;
    for (SceneBall& ball : scene.balls) {
        if (random.below(2) == 0)
            ball.state.w = {random.uniform(-200, 200), random.uniform(-200, 200),
                            random.uniform(-50, 50)};
        if (random.below(3) == 0) set_xy(ball.state.v, random.uniform(0, 3) * random.direction());
    }
    constexpr std::array kRates{5, 30, 60, 240, 1000};
    scene.solver.hz = kRates[random.below(5)];
    scene.limits = {20, 20000};
    return scene;
}

}  // namespace poolhall::testing
