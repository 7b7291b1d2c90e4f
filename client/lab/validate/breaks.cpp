#include "client/lab/corpora/bench_scenes.hpp"
#include "client/lab/corpora/random.hpp"
#include "client/lab/statistics/quantiles.hpp"
#include "client/lab/validate/tables.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <cstdio>

namespace poolhall::lab {

namespace {

// AtLarge, azbilliards.com, thread 568443: 124 racks of professional eight-ball on 7-ft tables: 66
// % of the breaks made a ball without a foul. Men's professional speed: 9.8 to 11.6 m/s.
constexpr double kMadeABall = 66;  ///< per cent
constexpr double kSlowest = 9.8;   ///< m/s
constexpr double kFastest = 11.6;

Scene rack(Random& random) {
    constexpr double kLoose = 3e-5;  // m; no two racks stand alike
    Scene scene = fifteen_ball_break(1e-4);
    for (SceneBall& ball : scene.balls)
        set_xy(ball.state.r, xy(ball.state.r) + kLoose * random.direction());
    const Vec2 cue{-0.635, random.uniform(-0.3, 0.3)};
    set_xy(scene.balls[0].state.r, cue);
    const Vec2 apex = xy(scene.balls[1].state.r) + 0.005 * random.direction();
    scene.strike = Strike{BallIndex{0}, apex - cue, random.uniform(kSlowest, kFastest)};
    scene.table.pockets = PocketModel::kPool;
    scene.solver.kind = SolverKind::kEvent;
    return scene;
}

/// What so many breaks bring.
struct Breaks {
    double made = 0;  ///< with a ball down and the cue ball not, per cent
    double down = 0;  ///< object balls a break
    double past = 0;  ///< object balls a break that ever cross the head string
};

bool is_past_head_string(const Scene& scene, const ShotTrace& trace, std::uint8_t ball) {
    const double head = -scene.table.length / 4;
    return std::any_of(trace.events.begin(), trace.events.end(), [&](const ShotEvent& event) {
        for (std::size_t i = 0; i < event.ball_count; ++i) {
            if (event.balls[i].value == ball && event.after[i].r.x < head) return true;
        }
        return false;
    });
}

Breaks breaks_of(std::uint64_t seed, std::size_t count) {
    Random random(seed);
    Breaks sum;
    for (std::size_t i = 0; i < count; ++i) {
        const Scene scene = rack(random);
        const ShotTrace trace = simulate(scene);
        int down = 0;
        for (std::uint8_t ball = 1; ball < scene.balls.size(); ++ball) {
            if (trace.balls[ball].motion == Motion::kPocketed) ++down;
            if (is_past_head_string(scene, trace, ball)) ++sum.past;
        }
        sum.down += down;
        if (down > 0 && trace.balls[0].motion != Motion::kPocketed) sum.made += 100;
    }
    const auto all = static_cast<double>(count);
    return {sum.made / all, sum.down / all, sum.past / all};
}

}  // namespace

std::vector<MeasuredTable> break_tables(std::uint64_t seed, std::size_t breaks) {
    const Breaks ours = breaks_of(seed, breaks);
    char note[160];
    std::snprintf(note, sizeof(note),
                  "Of %zu breaks: %.2f balls down and %.2f balls past the head string a break.",
                  breaks, ours.down, ours.past);
    MeasuredTable table{.name = "eight_ball_break",
                        .title = "Eight-ball breaks that make a ball without a scratch",
                        .unit = "%",
                        .source = "AtLarge, azbilliards.com thread 568443: 124 racks, 7-ft tables",
                        .accuracy = "4 % (one standard deviation of 124 racks)",
                        .digits = 1,
                        .note = note,
                        .models = {"rack by default"}};
    table.rows = {{"9.8 to 11.6 m/s", kMadeABall, false, {ours.made}}};
    return {table};
}

}  // namespace poolhall::lab
