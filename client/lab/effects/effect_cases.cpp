#include "client/lab/effects/effect_cases.hpp"

#include "client/lab/ensembles/ensembles.hpp"

#include <array>
#include <cassert>

namespace poolhall::lab {

namespace {

void as_it_is(Scene& /*scene*/) {}

void without_pockets(Scene& scene) {
    scene.table.pockets = PocketModel::kNone;
    scene.table.circles.clear();
}

template <BallBallModel kModel>
void balls_after(Scene& scene) {
    scene.effects.ball_ball.model = kModel;
}

template <RailModel kModel>
void rails_after(Scene& scene) {
    scene.effects.rail.model = kModel;
}

void ball_restitution_of_one(Scene& scene) {
    balls_after<BallBallModel::kRestitution>(scene);
    scene.effects.ball_ball.e = 1;
}

void frictionless_balls(Scene& scene) {
    balls_after<BallBallModel::kFriction>(scene);
    scene.effects.ball_ball.mu = 0;
    scene.effects.ball_ball.friction_by_speed.reset();
}

void rail_restitution_of_one(Scene& scene) {
    rails_after<RailModel::kRestitution>(scene);
    scene.effects.rail.e = 1;
}

template <auto kEffect>
void without(Scene& scene) {
    (scene.effects.*kEffect).reset();
}

/// Of the effect's coefficient.
template <auto kEffect, auto kCoefficient>
void with_zero(Scene& scene) {
    (*(scene.effects.*kEffect)).*kCoefficient = 0;
}

/// A cue that falls 0.2 m a metre: swerve.
void raised_cue(Scene& scene) {
    scene.strike->elevation = 0.2;
}

void level_cue(Scene& scene) {
    scene.strike->elevation = 0;
}

/// A cue that falls 0.6 m a metre: the cue ball jumps.
void jump(Scene& scene) {
    scene.strike->elevation = 0.6;
    scene.effects.airborne = AirborneSpec{};
}

void restitution_by_speed(Scene& scene) {
    scene.effects.rail.e_by_speed.emplace();
}

void constant_restitution(Scene& scene) {
    scene.effects.rail.e_by_speed.reset();
}

void touched_at_the_nose(Scene& scene) {
    scene.table.nose_height = scene.effects.rail.nose_height;
}

void touched_at_the_side(Scene& scene) {
    scene.table.nose_height.reset();
}

/// As other programs have them, for looks.
void wide_jaws(Scene& scene) {
    Mouths& mouths = scene.table.mouths.emplace();
    mouths.corner.jaw_radius = 0.02095;
    mouths.side.jaw_radius = 0.00795;
}

void sharp_jaws(Scene& scene) {
    scene.table.mouths.reset();
}

constexpr auto kElasticBalls = balls_after<BallBallModel::kElastic>;
constexpr auto kBallRestitution = balls_after<BallBallModel::kRestitution>;
constexpr auto kElasticRails = rails_after<RailModel::kElastic>;
constexpr auto kRailRestitution = rails_after<RailModel::kRestitution>;

// What e a model has stays when another takes its place, so that just one thing differs.
constexpr std::array kEffectCases{
    EffectCase{"linear_drag", "end_game", as_it_is, without<&Effects::linear_drag>,
               with_zero<&Effects::linear_drag, &LinearDragSpec::k>},
    EffectCase{"sliding", "two_balls", as_it_is, without<&Effects::sliding>,
               with_zero<&Effects::sliding, &SlidingSpec::mu>},
    EffectCase{"rolling", "two_balls", as_it_is, without<&Effects::rolling>,
               with_zero<&Effects::rolling, &RollingSpec::mu>},
    EffectCase{"spin_decay", "throw_and_spin", as_it_is, without<&Effects::spin_decay>,
               with_zero<&Effects::spin_decay, &SpinDecaySpec::mu>},
    EffectCase{"ball_ball restitution", "two_balls", kBallRestitution, kElasticBalls,
               ball_restitution_of_one},
    EffectCase{"ball_ball friction", "throw_and_spin", as_it_is, kBallRestitution,
               frictionless_balls},
    EffectCase{"ball_ball mathavan2014", "throw_and_spin",
               balls_after<BallBallModel::kMathavan2014>, balls_after<BallBallModel::kFriction>,
               nullptr},
    EffectCase{"rail restitution", "two_balls", kRailRestitution, kElasticRails,
               rail_restitution_of_one},
    EffectCase{"rail han2005", "throw_and_spin", rails_after<RailModel::kHan2005>, kRailRestitution,
               nullptr},
    EffectCase{"rail mathavan2010", "throw_and_spin", as_it_is, kRailRestitution, nullptr},
    EffectCase{"rail mathavan2010 fast", "throw_and_spin",
               rails_after<RailModel::kMathavan2010Fast>, kRailRestitution, nullptr},
    EffectCase{"rail e_by_speed", "throw_and_spin", restitution_by_speed, constant_restitution,
               nullptr},
    EffectCase{"rails touched at the nose", "throw_and_spin", touched_at_the_nose,
               touched_at_the_side, nullptr},
    EffectCase{"jaws of 4 mm for 21", "jaw_rattle", sharp_jaws, wide_jaws, nullptr},
    EffectCase{"jaws of 4 mm for 21", "nine_ball_break", sharp_jaws, wide_jaws, nullptr},
    EffectCase{"pockets end_game", "end_game", as_it_is, without_pockets, nullptr},
    EffectCase{"pockets circles", "two_balls", as_it_is, without_pockets, nullptr},
    EffectCase{"pockets pool", "nine_ball_break", as_it_is, without_pockets, nullptr},
    EffectCase{"elevation", "throw_and_spin", raised_cue, level_cue, nullptr},
    EffectCase{"airborne", "throw_and_spin", jump, without<&Effects::airborne>, nullptr},
};

// --- kernels ---------------------------------------------------------------------------------

/// Without any friction a shot has no end: it is cut off.
constexpr double kEndless = 5;  // s

void on_open_cloth(Scene& scene) {
    without_pockets(scene);
    scene.table.rails = false;
    scene.effects = {};
    scene.limits.time = kEndless;
}

void between_rails(Scene& scene) {
    without_pockets(scene);
    scene.effects = {};
    scene.limits.time = kEndless;
}

void rolling_only(Scene& scene) {
    without_pockets(scene);
    scene.effects = {};
    scene.effects.rolling = RollingSpec{};
}

void into_end_game_pockets(Scene& scene) {
    without_pockets(scene);
    scene.table.pockets = PocketModel::kEndGame;
}

void into_mouths(Scene& scene) {
    without_pockets(scene);
    scene.table.pockets = PocketModel::kPool;
}

constexpr std::array kKernelCases{
    KernelCase{"open_cloth", "two_balls", on_open_cloth},
    KernelCase{"rails", "two_balls", between_rails},
    KernelCase{"drag_rails", "end_game", without_pockets},
    KernelCase{"drag_rails_pockets", "end_game", as_it_is},
    KernelCase{"roll", "two_balls", rolling_only},
    KernelCase{"slide_roll", "two_balls", without<&Effects::spin_decay>},
    KernelCase{"slide_roll_spin", "two_balls", as_it_is},
    KernelCase{"slide_roll_spin_end_game", "two_balls", into_end_game_pockets},
    KernelCase{"slide_roll_spin_mouths", "two_balls", into_mouths},
    KernelCase{"everything", "two_balls", jump},
};

}  // namespace

std::span<const EffectCase> effect_cases() {
    return kEffectCases;
}

std::span<const KernelCase> kernel_cases() {
    return kKernelCases;
}

std::vector<Scene> changed_scenes(std::string_view ensemble, std::uint64_t seed, std::size_t count,
                                  ChangeScene change) {
    const Ensemble* const shots = find_ensemble(ensemble);
    assert(shots);
    std::vector<Scene> scenes = scenes_of(*shots, seed, count);
    for (Scene& scene : scenes)
        change(scene);
    return scenes;
}

}  // namespace poolhall::lab
