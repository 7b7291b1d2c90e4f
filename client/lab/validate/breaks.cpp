#include "client/lab/corpora/bench_scenes.hpp"
#include "client/lab/corpora/random.hpp"
#include "client/lab/validate/tables.hpp"
#include "shared/physics/effects/presets.hpp"
#include "shared/physics/simulate.hpp"
#include "shared/table/presets.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace poolhall::lab {

namespace {

// AtLarge, azbilliards.com, thread 568443: 124 racks of professional eight-ball on 7-ft tables: 66
// % of the breaks made a ball without a foul. Men's professional speed: 9.8 to 11.6 m/s.
constexpr double kMadeABall = 66;  ///< per cent
constexpr double kSlowest = 9.8;   ///< m/s
constexpr double kFastest = 11.6;

/// A table with its balls, cloth and rails.
struct Venue {
    const char* name = "";
    TablePreset table;
    BallSet balls;
    EffectsPreset effects;
};

constexpr std::array kVenues{
    Venue{"7ft_bar, bar cloth", TablePreset::kSevenFootBar, BallSet::kBarHeavy,
          EffectsPreset::kBar},
    Venue{"9ft, worsted cloth", TablePreset::kNineFoot, BallSet::kWpa, EffectsPreset::kWorsted}};

Scene rack(const Venue& venue, Random& random) {
    constexpr double kLoose = 3e-5;  // m; no two racks stand alike
    Scene scene = fifteen_ball_break(1e-4);
    const double apart = scene.table.length;
    scene.table = preset_value(venue.table);
    scene.ball = preset_value(venue.balls);
    scene.effects = preset_value(venue.effects);
    const double spot = scene.table.length / 4;
    const Vec2 moved{(scene.table.length - apart) / 4, 0};
    for (SceneBall& ball : scene.balls)
        set_xy(ball.state.r, xy(ball.state.r) + moved + kLoose * random.direction());
    const Vec2 cue{-spot, random.uniform(-0.25, 0.25)};
    set_xy(scene.balls[0].state.r, cue);
    if (const auto own = cue_ball_of(venue.balls)) scene.balls[0].mass = own->mass;
    const Vec2 apex = xy(scene.balls[1].state.r) + 0.005 * random.direction();
    scene.strike = Strike{BallIndex{0}, apex - cue, random.uniform(kSlowest, kFastest)};
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

Breaks breaks_of(const Venue& venue, std::uint64_t seed, std::size_t count) {
    Random random(seed);
    Breaks sum;
    for (std::size_t i = 0; i < count; ++i) {
        const Scene scene = rack(venue, random);
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
    MeasuredTable table{.name = "eight_ball_break",
                        .title = "Eight-ball breaks that make a ball without a scratch",
                        .unit = "%",
                        .source = "AtLarge, azbilliards.com thread 568443: 124 racks, 7-ft tables",
                        .accuracy = "4 % (one standard deviation of 124 racks)",
                        .digits = 1};
    MeasuredRow row{"9.8 to 11.6 m/s", kMadeABall};
    for (const Venue& venue : kVenues) {
        const Breaks ours = breaks_of(venue, seed, breaks);
        char note[160];
        std::snprintf(note, sizeof(note),
                      "%s, %zu breaks: %.2f balls down and %.2f past the head string a break. ",
                      venue.name, breaks, ours.down, ours.past);
        table.note += note;
        table.models.emplace_back(venue.name);
        row.ours.emplace_back(ours.made);
    }
    table.note.pop_back();
    table.rows = {row};
    return {table};
}

}  // namespace poolhall::lab
