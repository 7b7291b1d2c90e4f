#include "shared/physics/solvers/refusals.hpp"

#include "shared/physics/effects/kernels.hpp"

namespace poolhall {

namespace {

bool has_drag(const Effects& effects) {
    return effects.linear_drag && effects.linear_drag->k > 0;
}

}  // namespace

std::optional<SceneError> refusal_by_euler_steps(const Scene& scene) {
    if (!has_drag(scene.effects) || scene.effects.linear_drag->k < scene.solver.hz)
        return std::nullopt;
    return SceneError{"/effects/linear_drag/k",
                      "must be below the solver's hz: an Euler step would turn the ball round"};
}

std::optional<SceneError> refusal_by_closed_form(const Scene& scene) {
    const Effects& effects = scene.effects;
    const bool cloth = (effects.sliding && effects.sliding->mu > 0) ||
                       (effects.rolling && effects.rolling->mu > 0);
    if (has_drag(effects) && cloth)
        return SceneError{"/solver/kind",
                          "has no closed form of linear_drag together with sliding or rolling"};
    if (SetOf<AllEffects>::calls_for_force(scene))
        return SceneError{"/solver/kind", "has no closed form of a force that the scene calls for"};
    return std::nullopt;
}

}  // namespace poolhall
