#include "client/lab/corpora/corpora.hpp"

#include "client/lab/corpora/scene_makers.hpp"
#include "shared/game/end_game.hpp"
#include "shared/math/state_hash.hpp"
#include "shared/physics/effects/presets.hpp"
#include "shared/physics/simulate.hpp"
#include "shared/table/presets.hpp"

#include <array>

namespace poolhall::lab {

namespace {

/// A first shot of the end game from anywhere on the base line.
template <SolverKind kSolver, int kHz>
Scene end_game_shot(Random& random, int /*shot*/) {
    GameState state = kEndGameRules.new_game(Seat{0});
    state.scene.balls[state.cue_ball.value].state.r.y = random.uniform(-0.33, 0.33);
    state.scene.strike = Strike{state.cue_ball, random.direction(), end_game::kShotSpeed};
    state.scene.solver = {kSolver, kHz};
    return state.scene;
}

Scene table_of_balls(Random& random, int shot) {
    const std::size_t balls = 2 + static_cast<std::size_t>(shot) % 15;
    Scene scene = random_scene(random, balls, random.uniform(0.5, 12));
    if (shot % 2 == 1) scene.effects.rail = {RailModel::kRestitution, random.uniform(0, 1)};
    return scene;
}

template <SolverKind kSolver>
Scene dragged_balls(Random& random, int shot) {
    Scene scene = table_of_balls(random, shot);
    scene.solver.kind = kSolver;
    return scene;
}

Scene rack_broken(Random& random, int shot) {
    Scene scene =
        break_scene(2 + shot % 4, shot % 3 == 0 ? 0 : 1e-3 / (1 + shot), random.uniform(1, 12));
    scene.strike->direction.y = random.uniform(-0.05, 0.05);
    return scene;
}

/// The cue's tip anywhere on the ball, and every model of impacts in turn.
Scene cloth_scene(Random& random, int shot) {
    Scene scene = table_of_balls(random, shot);
    scene.effects = cloth_effects();
    scene.effects.ball_ball.model = static_cast<BallBallModel>(shot % 3);
    scene.effects.rail.model = static_cast<RailModel>(shot / 3 % 5);
    scene.strike->offset = 0.9 * random.direction();
    scene.strike->elevation = random.uniform(0, 0.5);
    return scene;
}

template <SolverKind kSolver, int kHz>
Scene balls_on_cloth(Random& random, int shot) {
    Scene scene = cloth_scene(random, shot);
    scene.solver = {kSolver, kHz};
    return scene;
}

template <SolverKind kSolver, int kHz>
Scene break_into_mouths(Random& random, int shot) {
    Scene scene = rack_broken(random, shot);
    scene.effects = cloth_effects();
    scene.table.pockets = PocketModel::kPool;
    scene.solver = {kSolver, kHz};
    return scene;
}

template <SolverKind kSolver, int kHz>
Scene jump(Random& random, int shot) {
    Scene scene = cloth_scene(random, shot);
    scene.effects.airborne = AirborneSpec{};
    scene.strike->elevation = random.uniform(0.3, 1.5);
    scene.strike->speed = random.uniform(2, 5);
    scene.solver = {kSolver, kHz};
    return scene;
}

/// Every table with its cloth and every cue in turn; half with rails touched at the nose, half with
/// the cloth rubbing while two balls touch.
template <SolverKind kSolver, int kHz>
Scene preset_shot(Random& random, int shot) {
    const auto table = kValues<TablePreset>[static_cast<std::size_t>(shot) % kCount<TablePreset>];
    const bool snooker = table == TablePreset::kTwelveFootSnooker;
    const bool carom = table == TablePreset::kTenFootCarom;
    Scene scene =
        scene_of({{-0.4, random.uniform(-0.3, 0.3)}, {0.2, 0}, {0.35, 0.1}, {0.35, -0.1}});
    scene.table = preset_value(table);
    scene.ball = preset_value(snooker ? BallSet::kSnooker
                              : carom ? BallSet::kCarom
                                      : BallSet::kWpa);
    scene.effects = preset_value(snooker ? EffectsPreset::kSnooker
                                 : carom ? EffectsPreset::kHeatedCarom
                                         : EffectsPreset::kWorsted);
    if (shot % 2 == 0) scene.table.nose_height = scene.effects.rail.nose_height;
    if (shot % 4 < 2) scene.effects.ball_ball.model = BallBallModel::kMathavan2014;
    if (shot % 3 == 0) scene.effects.rail.model = RailModel::kHan2005;
    const Vec2 target{0.2, random.uniform(-0.05, 0.05)};
    const double speed = random.uniform(0.5, 8);
    const double off_centre = random.uniform(0, 0.55);
    scene.strike = Strike{BallIndex{0}, target - xy(scene.balls[0].state.r), speed,
                          off_centre * random.direction()};
    scene.strike->cue = preset_value(kValues<CuePreset>[static_cast<std::size_t>(shot) % 3]);
    scene.solver = {kSolver, kHz};
    return scene;
}

using enum SolverKind;

constexpr std::array kCorpora{
    Corpus{"end_game_euler_30", 500, end_game_shot<kEuler, 30>},
    Corpus{"end_game_euler_120", 500, end_game_shot<kEuler, 120>},
    Corpus{"end_game_overlap_30", 500, end_game_shot<kOverlap, 30>},
    Corpus{"end_game_event", 500, end_game_shot<kEvent, 30>},
    Corpus{"tables_euler_30", 300, dragged_balls<kEuler>},
    Corpus{"tables_overlap_30", 300, dragged_balls<kOverlap>},
    Corpus{"tables_exact_arc_30", 300, dragged_balls<kExactArc>},
    Corpus{"tables_event", 300, dragged_balls<kEvent>},
    Corpus{"racks_euler_30", 200, rack_broken},
    Corpus{"cloth_euler_120", 150, balls_on_cloth<kEuler, 120>},
    Corpus{"cloth_overlap_120", 150, balls_on_cloth<kOverlap, 120>},
    Corpus{"cloth_semi_implicit_120", 150, balls_on_cloth<kSemiImplicit, 120>},
    Corpus{"cloth_exact_arc_30", 150, balls_on_cloth<kExactArc, 30>},
    Corpus{"cloth_event", 300, balls_on_cloth<kEvent, 30>},
    Corpus{"pool_semi_implicit_120", 60, break_into_mouths<kSemiImplicit, 120>},
    Corpus{"pool_exact_arc_30", 60, break_into_mouths<kExactArc, 30>},
    Corpus{"pool_event", 200, break_into_mouths<kEvent, 30>},
    Corpus{"jumps_semi_implicit_120", 60, jump<kSemiImplicit, 120>},
    Corpus{"jumps_event", 200, jump<kEvent, 30>},
    Corpus{"presets_euler_120", 70, preset_shot<kEuler, 120>},
    Corpus{"presets_event", 210, preset_shot<kEvent, 30>},
};

}  // namespace

std::span<const Corpus> corpora() {
    return kCorpora;
}

std::vector<Scene> scenes_of(const Corpus& corpus) {
    Random random(2026);
    std::vector<Scene> scenes;
    for (int shot = 0; shot < corpus.shots; ++shot)
        scenes.push_back(corpus.make(random, shot));
    return scenes;
}

std::uint64_t hash_of(const Corpus& corpus) {
    StateHash hash;
    Simulator simulator;
    ShotTrace trace;
    for (const Scene& scene : scenes_of(corpus)) {
        simulator.simulate(scene, 0, trace);
        hash.add(trace.hash);
    }
    return hash.value();
}

}  // namespace poolhall::lab
