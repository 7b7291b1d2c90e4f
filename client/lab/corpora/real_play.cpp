#include "client/lab/corpora/real_play.hpp"

#include "client/lab/corpora/bench_scenes.hpp"
#include "client/lab/corpora/scene_makers.hpp"

#include <array>

namespace poolhall::lab {

namespace {

/// Those of a match (shared/game/settings.hpp).
constexpr Limits kLimits{120, 500};

Scene on_full_table(Scene scene) {
    scene.table.pockets = PocketModel::kPool;
    scene.effects = cloth_effects();
    scene.effects.ball_ball.friction_by_speed = FrictionBySpeed{};
    scene.effects.airborne = AirborneSpec{};
    scene.solver.kind = SolverKind::kEvent;
    scene.limits = kLimits;
    return scene;
}

/// One shot in five with a cue that falls up to 0.1 m a metre; half of them without english.
void hold_cue(Random& random, Scene& scene, double farthest) {
    Vec2 offset = farthest * random.direction();
    if (random.below(2) == 0) offset.x = 0;
    scene.strike->offset = offset;
    if (random.below(5) == 0) scene.strike->elevation = random.uniform(0, 0.1);
}

/// From the kitchen into a rack that stands a little differently each time.
Scene breaks(Random& random) {
    constexpr double kLoose = 3e-5;  // m; less than a third of the gaps
    Scene scene =
        on_full_table(random.below(2) == 0 ? nine_ball_break() : fifteen_ball_break(1e-4));
    for (SceneBall& ball : scene.balls)
        set_xy(ball.state.r, xy(ball.state.r) + kLoose * random.direction());
    const Vec2 cue{-0.635, random.uniform(-0.25, 0.25)};
    set_xy(scene.balls[0].state.r, cue);
    const Vec2 target{0.635, random.uniform(-0.02, 0.02)};
    scene.strike = Strike{BallIndex{0}, target - cue, random.uniform(6, 10)};
    hold_cue(random, scene, 0.2);
    return scene;
}

/// At ball 1 among others, full to `thinnest` (the share of a contact distance that it is aimed
/// past the middle).
Scene at_object(Random& random, std::size_t balls, double speed, double thinnest) {
    Scene scene = on_full_table(random_scene(random, balls, speed));
    aim_at_object(scene, random.uniform(-thinnest, thinnest));
    hold_cue(random, scene, 0.5);
    return scene;
}

Scene run_outs(Random& random) {
    const std::size_t balls = 2 + random.below(8);
    const double speed = random.uniform(0.8, 3.5);
    return at_object(random, balls, speed, 0.9);
}

Scene safeties(Random& random) {
    const std::size_t balls = 4 + random.below(9);
    const double speed = random.uniform(0.3, 1.5);
    return at_object(random, balls, speed, 0.98);
}

/// A nudge, mostly of the cue ball alone.
Scene taps(Random& random) {
    const std::size_t balls = 4 + random.below(9);
    Scene scene = on_full_table(random_scene(random, balls, random.uniform(0.05, 0.4)));
    if (random.below(4) == 0) aim_at_object(scene, random.uniform(-0.9, 0.9));
    hold_cue(random, scene, 0.3);
    return scene;
}

constexpr std::array kKinds{
    PlayKind{"breaks", "Breaks", breaks},
    PlayKind{"run_outs", "Run-outs", run_outs},
    PlayKind{"safeties", "Safeties", safeties},
    PlayKind{"taps", "Taps", taps},
};

}  // namespace

std::span<const PlayKind> kinds_of_play() {
    return kKinds;
}

}  // namespace poolhall::lab
