#include "shared/game/settings.hpp"

#include "shared/physics/check.hpp"
#include "shared/physics/simulate.hpp"

#include <string>

namespace poolhall {

namespace {

using MaybeError = std::optional<SceneError>;

/// A coefficient of 0 is as good as absent; one that is hardly there lets balls move for minutes.
template <class Spec>
MaybeError check_friction(const std::optional<Spec>& spec, const std::string& effect) {
    if (!spec || spec->mu == 0 || spec->mu >= kLeastGameFriction) return std::nullopt;
    return SceneError{"/effects/" + effect + "/mu", "must be 0 or at least 0.003 in a game"};
}

bool has_drag(const Effects& effects) {
    return effects.linear_drag && effects.linear_drag->k > 0;
}

MaybeError check_drag(const Effects& effects) {
    if (!has_drag(effects)) return std::nullopt;
    const auto [k, stop_speed] = *effects.linear_drag;
    if (k < kLeastGameDrag)
        return SceneError{"/effects/linear_drag/k", "must be 0 or at least 0.1 in a game"};
    if (stop_speed >= kLeastGameStopSpeed && stop_speed <= kMaxGameStopSpeed) return std::nullopt;
    return SceneError{"/effects/linear_drag/stop_speed", "must be from 0.001 to 0.5 in a game"};
}

/// Whether the balls of every shot come to rest.
MaybeError check_rest(const Effects& effects) {
    if (auto error = check_friction(effects.sliding, "sliding")) return error;
    if (auto error = check_friction(effects.rolling, "rolling")) return error;
    if (auto error = check_friction(effects.spin_decay, "spin_decay")) return error;
    if (auto error = check_drag(effects)) return error;
    const bool rolls_out = effects.rolling && effects.rolling->mu > 0;
    if (has_drag(effects) || rolls_out) return std::nullopt;
    return SceneError{"/effects", "must bring the balls to rest: with linear_drag or rolling"};
}

/// Whether the solver is fit to play with, at a cost that a server can bear.
MaybeError check_solver(const SolverSpec& solver) {
    if (solver.kind == SolverKind::kOverlap)
        return SceneError{"/solver/kind", "must not be overlap in a game: it misses impacts"};
    if (!has_ticks(solver.kind) || solver.hz <= kMaxGameHz) return std::nullopt;
    return SceneError{"/solver/hz", "must be at most 1000 in a game"};
}

}  // namespace

std::optional<SceneError> check(const Ruleset& rules, const GameSettings& settings) {
    if (settings == GameSettings{}) return std::nullopt;
    const Scene scene = new_game(rules, Seat{0}, settings).scene;
    if (auto error = check(scene)) return error;
    if (auto error = check_solver(scene.solver)) return error;
    return check_rest(scene.effects);
}

GameState new_game(const Ruleset& rules, Seat first, const GameSettings& settings) {
    GameState state = rules.new_game(first);
    if (settings == GameSettings{}) return state;
    if (settings.effects) state.scene.effects = *settings.effects;
    if (settings.solver) state.scene.solver = *settings.solver;
    state.scene.limits = kGameLimits;
    return state;
}

}  // namespace poolhall
