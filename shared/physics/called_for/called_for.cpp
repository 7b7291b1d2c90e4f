#include "shared/physics/called_for/called_for.hpp"

#include "shared/physics/called_for/free_path.hpp"
#include "shared/physics/effects/all_effects.hpp"
#include "shared/physics/motion/cloth_hooks.hpp"

#include <algorithm>
#include <tuple>
#include <type_traits>

namespace poolhall {

namespace {

template <class Effect>
constexpr bool gives_energy() {
    if constexpr (requires { Effect::kGivesEnergy; }) return true;
    return ForceEffect<Effect>;
}

template <class... Effect>
bool calls_for_energy([[maybe_unused]] const Scene& scene,
                      std::type_identity<std::tuple<Effect...>> /*effects*/) {
    return ((gives_energy<Effect>() && Effect::called_for(scene)) || ...);
}

Start start_of(std::span<const MovingBall> balls) {
    Start start;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const MovingBall& ball = balls[i];
        if (is_at_rest(ball)) continue;
        ++start.movers;
        start.a_mover = i;
        start.energy += kinetic_energy(ball);
        start.off_cloth = start.off_cloth || ball.height != 0 || ball.climb != 0;
        start.side_spin = start.side_spin || ball.w.z != 0;
    }
    return start;
}

bool have_one_radius(std::span<const MovingBall> balls) {
    return std::all_of(balls.begin(), balls.end(),
                       [&](const MovingBall& ball) { return ball.radius == balls[0].radius; });
}

/// Whether an impact of two balls leaves their spin about the vertical alone.
bool keeps_side_spin(const BallBallSpec& spec) {
    switch (spec.model) {
        case BallBallModel::kElastic:
        case BallBallModel::kRestitution:
            return true;
        case BallBallModel::kFriction:
            return !has_friction(spec);
        default:
            return false;
    }
}

bool keeps_side_spin(const RailSpec& spec) {
    return spec.model == RailModel::kElastic || spec.model == RailModel::kRestitution;
}

}  // namespace

Prospect prospect_of(const Scene& scene, std::span<const MovingBall> balls, ReachMemory& memory) {
    Prospect prospect;
    if (calls_for_energy(scene, std::type_identity<AllEffects>{})) return prospect;
    const Start start = start_of(balls);
    prospect.moves = start.movers > 0;
    prospect.meets = balls.size() > 1;
    if (!prospect.moves || (start.off_cloth && scene.effects.airborne)) return prospect;
    bound_reach(scene, balls, start, memory, prospect);
    if (scene.effects.airborne && prospect.meets && !have_one_radius(balls)) {
        // The normal of their impact slopes, and nothing is known of where they fly.
        prospect = {};
        return prospect;
    }
    prospect.flies = false;
    prospect.side_spin = start.side_spin ||
                         (prospect.meets && !keeps_side_spin(scene.effects.ball_ball)) ||
                         (prospect.rails && !keeps_side_spin(scene.effects.rail));
    return prospect;
}

bool takes_no_part(const MovingBall& ball, const Prospect& prospect) {
    return prospect.reach_is_bounded && is_at_rest(ball) &&
           are_apart(prospect.reach, Box::around(ball.r, ball.r, ball.radius));
}

}  // namespace poolhall
