#include "client/lab/ensembles/ensembles.hpp"

#include "client/lab/corpora/bench_scenes.hpp"
#include "client/lab/corpora/scene_makers.hpp"
#include "shared/analysis/agreement.hpp"
#include "shared/game/end_game.hpp"
#include "shared/math/state_hash.hpp"
#include "shared/physics/effects/pocket_circles.hpp"
#include "shared/table/pool_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace poolhall::lab {

namespace {

/// Six holes in unbroken rails, which every solver knows.
Table table_with_circles() {
    Table table;
    table.pockets = PocketModel::kCircles;
    const double x = table.length / 2;
    const double y = table.width / 2;
    constexpr double kCorner = 0.06;
    constexpr double kSide = 0.045;
    table.circles = {{"NW", {-x, y}, kCorner}, {"N", {0, y}, kSide},  {"NE", {x, y}, kCorner},
                     {"SE", {x, -y}, kCorner}, {"S", {0, -y}, kSide}, {"SW", {-x, -y}, kCorner}};
    return table;
}

/// Balls anywhere on real cloth; ball 0 is struck at a random speed.
Scene on_cloth(Random& random, std::size_t balls, double slowest, double fastest) {
    Scene scene = random_scene(random, balls, random.uniform(slowest, fastest));
    scene.effects = cloth_effects();
    return scene;
}

/// Two balls on the cloth of a table with circles, neither in one of them.
Scene between_circles(Random& random) {
    while (true) {
        Scene scene = on_cloth(random, 2, 1, 5);
        scene.table = table_with_circles();
        const PocketCircles pockets(scene);
        if (std::none_of(scene.balls.begin(), scene.balls.end(), [&](const SceneBall& ball) {
                return pockets.at(xy(ball.state.r)).has_value();
            }))
            return scene;
    }
}

/// The tip anywhere within half a radius of the middle.
Scene one_ball(Random& random) {
    Scene scene = on_cloth(random, 1, 0.5, 4);
    scene.strike->offset = 0.5 * random.direction();
    return scene;
}

/// Full to thin, centre hits.
Scene two_balls(Random& random) {
    Scene scene = between_circles(random);
    aim_at_object(scene, random.uniform(-0.95, 0.95));
    return scene;
}

/// Cuts of 75 to 88 degrees.
Scene thin_cut(Random& random) {
    Scene scene = between_circles(random);
    const double side = random.below(2) == 0 ? -1 : 1;
    aim_at_object(scene, side * random.uniform(0.966, 0.9994));
    return scene;
}

/// A rolling ball without spin in a table of elastic rails: it stops after about `rails` of them.
/// Its way would take 17 m at 10 rails and 160 km at 100,000, so long chains have a rougher cloth
/// and a faster ball, or they would last for hours.
template <int kRails>
Scene bank_chain(Random& random) {
    Scene scene = scene_of({{0, 0}});
    scene.effects.rolling = RollingSpec{kRails > 10 ? 0.1 : 0.01};
    const Vec2 edge = inset(scene.table, scene.ball.radius);
    set_xy(scene.balls[0].state.r,
           {random.uniform(-0.9, 0.9) * edge.x, random.uniform(-0.9, 0.9) * edge.y});
    const Vec2 direction = normalized(random.direction());
    const double rails_a_metre =
        std::abs(direction.x) / (2 * edge.x) + std::abs(direction.y) / (2 * edge.y);
    const double way = kRails / rails_a_metre;
    const double speed = std::sqrt(2 * scene.effects.rolling->mu * scene.gravity * way);
    set_xy(scene.balls[0].state.v, speed * direction);
    scene.limits = {1000, 2 * kRails + 100};
    return scene;
}

/// A break into real mouths, 6 to 10 m/s from a cue ball in the kitchen, aimed within 2 cm of the
/// head ball's centre; no two racks stand alike, as on a table.
Scene broken(Random& random, Scene scene) {
    constexpr double kLoose = 3e-5;  // m; less than a third of the gaps
    for (SceneBall& ball : scene.balls)
        set_xy(ball.state.r, xy(ball.state.r) + kLoose * random.direction());
    const Vec2 cue{-0.635, random.uniform(-0.25, 0.25)};
    set_xy(scene.balls[0].state.r, cue);
    const Vec2 target{0.635, random.uniform(-0.02, 0.02)};
    scene.strike = Strike{BallIndex{0}, target - cue, random.uniform(6, 10)};
    scene.table.pockets = PocketModel::kPool;
    return scene;
}

Scene nine_balls(Random& random) {
    return broken(random, nine_ball_break());
}

Scene fifteen_balls(Random& random) {
    return broken(random, fifteen_ball_break(1e-4));
}

/// The first shot of a game, from anywhere on the base line, full to just past the 8-ball.
Scene end_game_shot(Random& random) {
    const GameState state = kEndGameRules.new_game(Seat{0});
    Scene scene = state.scene;
    scene.balls[state.cue_ball.value].state.r.y = random.uniform(-0.33, 0.33);
    scene.strike = Strike{state.cue_ball, {}, end_game::kShotSpeed};
    aim_at_object(scene, random.uniform(-1.1, 1.1));
    return scene;
}

/// English of any kind, throw that depends on speed, and rails after Mathavan.
Scene throw_and_spin(Random& random) {
    Scene scene = two_balls(random);
    scene.strike->offset = 0.5 * random.direction();
    scene.effects.ball_ball.friction_by_speed = FrictionBySpeed{};
    scene.effects.rail.model = RailModel::kMathavan2010;
    return scene;
}

/// From the middle of the table at the jaws of any mouth.
Scene jaw_rattle(Random& random) {
    Scene scene = scene_of({0.4 * random.direction()});
    scene.effects = cloth_effects();
    scene.table.pockets = PocketModel::kPool;
    const PoolTable table(scene.table);
    const Hole& hole = table.holes()[random.below(kPocketCount)];
    constexpr double kMouth = 0.07;  // m: a little more than half of it
    const Vec2 target = hole.centre + kMouth * random.direction();
    scene.strike = Strike{BallIndex{0}, target - xy(scene.balls[0].state.r), random.uniform(1, 5)};
    return scene;
}

constexpr auto kUnfolding = ReferenceKind::kUnfolding;
constexpr auto kEventIn113Bits = ReferenceKind::kEventIn113Bits;

// A full run has at least 1000 shots of each but the longest chain. A shot of it lasts 550 s and
// has 4 million ticks at 7680 Hz.
constexpr std::array kEnsembles{
    Ensemble{"one_ball", "One ball", one_ball, 1000, 40, 10},
    Ensemble{"two_balls", "Two balls", two_balls, 1000, 40, 10, kEventIn113Bits,
             WinnerRule::kFirstPocketed},
    Ensemble{"thin_cut", "Thin cuts", thin_cut, 1000, 40, 10, kEventIn113Bits,
             WinnerRule::kFirstPocketed},
    Ensemble{"bank_chain_10", "Bank chain of 10 rails", bank_chain<10>, 1000, 40, 5, kUnfolding},
    Ensemble{"bank_chain_1000", "Bank chain of 1,000 rails", bank_chain<1000>, 1000, 20, 1,
             kUnfolding, WinnerRule::kNone, 960},
    Ensemble{"bank_chain_100000", "Bank chain of 100,000 rails", bank_chain<100000>, 20, 4, 0.1,
             kUnfolding, WinnerRule::kNone, 480},
    Ensemble{"nine_ball_break", "Nine-ball break", nine_balls, 1000, 20, 10, kEventIn113Bits,
             WinnerRule::kFirstPocketed},
    Ensemble{"fifteen_ball_break", "Fifteen-ball break", fifteen_balls, 1000, 20, 10,
             kEventIn113Bits, WinnerRule::kFirstPocketed},
    Ensemble{"end_game", "The end game", end_game_shot, 1000, 40, 10, kEventIn113Bits,
             WinnerRule::kEndGame},
    Ensemble{"throw_and_spin", "Throw and spin, Mathavan's rails", throw_and_spin, 1000, 40, 10,
             kEventIn113Bits, WinnerRule::kFirstPocketed},
    Ensemble{"jaw_rattle", "Jaw rattles", jaw_rattle, 1000, 40, 10, kEventIn113Bits,
             WinnerRule::kFirstPocketed},
};

/// Another one for each ensemble of one seed.
std::uint64_t seed_of(std::string_view name, std::uint64_t seed) {
    StateHash hash;
    hash.add(seed);
    for (const char c : name)
        hash.add(std::uint64_t{static_cast<unsigned char>(c)});
    return hash.value();
}

}  // namespace

std::span<const Ensemble> ensembles() {
    return kEnsembles;
}

const Ensemble* find_ensemble(std::string_view name) {
    const auto found = std::find_if(kEnsembles.begin(), kEnsembles.end(),
                                    [&](const Ensemble& one) { return one.name == name; });
    return found == kEnsembles.end() ? nullptr : &*found;
}

std::optional<int> winner_of(const Ensemble& ensemble, const Scene& scene, const ShotTrace& trace) {
    if (ensemble.winner == WinnerRule::kEndGame) {
        GameState state = kEndGameRules.new_game(Seat{0});
        state.scene = scene;
        const auto winner = end_game::rule(state, trace).winner;
        return winner ? std::optional<int>(winner->value) : std::nullopt;
    }
    const auto ball = ensemble.winner == WinnerRule::kFirstPocketed
                          ? analysis::first_pocketed(trace)
                          : std::nullopt;
    return ball ? std::optional<int>(ball->value) : std::nullopt;
}

std::vector<Scene> scenes_of(const Ensemble& ensemble, std::uint64_t seed, std::size_t count) {
    Random random(seed_of(ensemble.name, seed));
    std::vector<Scene> scenes;
    while (scenes.size() < count) {
        Scene& scene = scenes.emplace_back(ensemble.make(random));
        scene.id = std::string(ensemble.name) + "/" + std::to_string(scenes.size());
        scene.solver.kind = SolverKind::kEvent;
    }
    return scenes;
}

}  // namespace poolhall::lab
