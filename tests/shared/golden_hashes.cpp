// Prints `name hash` for a few corpora of shots. tests/golden/hashes.txt holds what every compiler,
// optimisation level and processor must print.

#include "shared/game/end_game.hpp"
#include "shared/math/state_hash.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/scenes.hpp"

#include <cstdio>

namespace poolhall::testing {

namespace {

/// The hash of a corpus: of the hashes of `shots` scenes that `make` gives.
template <class Make>
void print_corpus(const char* name, int shots, Make make) {
    Random random(2026);
    StateHash hash;
    ShotTrace trace;
    for (int i = 0; i < shots; ++i) {
        simulate(make(random, i), 0, trace);
        hash.add(trace.hash);
    }
    std::printf("%s %s\n", name, to_hex(hash.value()).c_str());
}

/// A first shot of the end game from anywhere on the base line.
Scene end_game_shot(Random& random, SolverSpec solver) {
    GameState state = kEndGameRules.new_game(Seat{0});
    state.scene.balls[state.cue_ball.value].state.r.y = random.uniform(-0.33, 0.33);
    state.scene.strike = Strike{state.cue_ball, random.direction(), end_game::kShotSpeed};
    state.scene.solver = solver;
    return state.scene;
}

Scene table_of_balls(Random& random, int i, SolverKind solver) {
    const std::size_t balls = 2 + static_cast<std::size_t>(i) % 15;
    Scene scene = random_scene(random, balls, random.uniform(0.5, 12));
    scene.solver.kind = solver;
    if (i % 2 == 1) scene.effects.rail = {RailModel::kRestitution, random.uniform(0, 1)};
    return scene;
}

Scene rack_broken(Random& random, int i) {
    Scene scene = break_scene(2 + i % 4, i % 3 == 0 ? 0 : 1e-3 / (1 + i), random.uniform(1, 12));
    scene.strike->direction.y = random.uniform(-0.05, 0.05);
    return scene;
}

void print_all() {
    for (const auto& [name, solver] : {std::pair{"end_game_euler_30", SolverSpec{}},
                                       {"end_game_euler_120", {SolverKind::kEuler, 120}},
                                       {"end_game_overlap_30", {SolverKind::kOverlap, 30}}}) {
        print_corpus(name, 500, [solver = solver](Random& random, int) {
            return end_game_shot(random, solver);
        });
    }
    for (const auto& [name, solver] : {std::pair{"tables_euler_30", SolverKind::kEuler},
                                       {"tables_overlap_30", SolverKind::kOverlap}}) {
        print_corpus(name, 300, [solver = solver](Random& random, int i) {
            return table_of_balls(random, i, solver);
        });
    }
    print_corpus("racks_euler_30", 200, rack_broken);
}

}  // namespace

}  // namespace poolhall::testing

int main() {
    poolhall::testing::print_all();
}
