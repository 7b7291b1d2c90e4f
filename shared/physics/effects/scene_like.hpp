#pragma once

namespace poolhall {

/// What effects are made from, so that they lie below the scene that has them: table, common ball,
/// gravity (m/s^2) and the parameters of all effects. poolhall::Scene is one.
template <class T>
concept SceneLike = requires(const T& scene) {
    scene.table;
    scene.ball;
    scene.gravity;
    scene.effects;
};

}  // namespace poolhall
