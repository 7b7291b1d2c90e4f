#include "client/lab/ensembles/ensembles.hpp"
#include "client/lab/validate/cases.hpp"
#include "client/lab/validate/tables.hpp"
#include "shared/analysis/agreement.hpp"
#include "shared/physics/effects/presets.hpp"
#include "shared/physics/simulate.hpp"
#include "shared/table/pool_table.hpp"
#include "shared/table/presets.hpp"

#include <cmath>
#include <cstdio>
#include <string>

namespace poolhall::lab {

namespace {

// TP 3.5 to 3.8 (second hand): a corner pocket, approached along the rail, that is at 43 degrees to
// the line into it.
constexpr double kSlowWidth = 86;     ///< mm of parallel lines that go in
constexpr double kMostShift = 15;     ///< mm, of the middle of them between slow and fast
constexpr double kFromBisector = 43;  ///< degrees
constexpr double kSlow = 0.7;         ///< m/s; just enough for the way
constexpr double kMedium = 2;
constexpr double kFast = 4;

struct Opening {
    double width = 0;   ///< mm
    double middle = 0;  ///< mm, to the left of the line to the pocket
};

/// A rolling ball towards the NE pocket, `offset` m to the left of the line to its hole.
Scene shot_at(const Mouths& mouths, double offset, double speed) {
    Scene scene;
    scene.table.pockets = PocketModel::kPool;
    scene.table.mouths = mouths;
    scene.effects = preset_value(EffectsPreset::kWorsted);
    scene.solver.kind = SolverKind::kEvent;
    const double angle = (45 - kFromBisector) * kDegree;
    const Vec2 way{std::cos(angle), std::sin(angle)};
    const Vec2 left{-way.y, way.x};
    const PoolTable table(scene.table);
    const Vec2 hole = table.holes()[static_cast<std::size_t>(Pocket::kNorthEast)].centre;
    constexpr double kWay = 1;  // m
    const Vec2 from = hole - kWay * way + offset * left;
    const double radius = scene.ball.radius;
    scene.balls = {{"1",
                    {{from.x, from.y, 0},
                     {speed * way.x, speed * way.y, 0},
                     {-speed * way.y / radius, speed * way.x / radius, 0}}}};
    return scene;
}

/// Whether it falls without having met the far end of the table.
bool falls(Scene scene, double speed) {
    scene.limits.time = 4 / speed;
    const FinalBall ball = simulate(scene).balls[0];
    return ball.motion == Motion::kPocketed && ball.pocket == Pocket::kNorthEast;
}

Opening opening_at(const Mouths& mouths, double speed) {
    constexpr double kStep = 0.25;  // mm
    // The rail itself ends the sweep on the left.
    const double rail = Scene{}.table.width / 2 - BallSpec{}.radius;
    double sum = 0;
    int count = 0;
    for (double offset = -120; offset <= 120; offset += kStep) {
        const Scene scene = shot_at(mouths, offset / 1000, speed);
        if (scene.balls[0].state.r.y >= rail || !falls(scene, speed)) continue;
        sum += offset;
        ++count;
    }
    return {kStep * count, count > 0 ? sum / count : 0};
}

/// Of so many shots of the ensemble, the share of those that end with other balls down when the
/// mouths are those, in per cent.
double changed_verdicts(const char* ensemble, const Mouths& mouths) {
    constexpr std::size_t kShots = 200;
    int changed = 0;
    for (Scene scene : scenes_of(*find_ensemble(ensemble), 1, kShots)) {
        const ShotTrace trace = simulate(scene);
        scene.table.mouths = mouths;
        if (!analysis::is_same_verdict(trace, simulate(scene))) ++changed;
    }
    return 100.0 * changed / static_cast<double>(kShots);
}

/// Jaws as they were drawn for looks (pooltool).
Mouths wide_jaws() {
    Mouths mouths;
    mouths.corner.jaw_radius = 0.02095;
    mouths.side.jaw_radius = 0.00795;
    return mouths;
}

std::string note_on_jaws() {
    const Mouths wide = wide_jaws();
    char note[260];
    std::snprintf(note, sizeof(note),
                  "The sweep ends where a ball 1 m off would begin in the rail. From jaws of 21 mm "
                  "to 4 mm the balls that are down differ in %.1f %% of the jaw "
                  "rattles and %.1f %% of the nine-ball breaks of poolhall-lab accuracy.",
                  changed_verdicts("jaw_rattle", wide), changed_verdicts("nine_ball_break", wide));
    return note;
}

}  // namespace

std::vector<MeasuredTable> pocket_tables() {
    MeasuredTable width{.name = "corner_pocket",
                        .title = "Corner pocket, along the rail: width of what goes in",
                        .unit = "mm",
                        .source = "TP 3.5 to 3.8 (Alciatore, second hand)",
                        .accuracy = "computed there from the pocket's geometry: some mm",
                        .digits = 1,
                        .reach = 10,
                        .note = note_on_jaws(),
                        .models = {"9ft", "9ft, jaws of 21 mm", "9ft_pro"}};
    MeasuredRow slow{"width at 0.7 m/s", kSlowWidth};
    MeasuredRow medium{"2 m/s: width lost since 0.7 m/s", {0, kSlowWidth}};
    MeasuredRow fast{"4 m/s: width lost since 2 m/s", {0, kSlowWidth}};
    MeasuredRow shift{"its middle moves, slow to fast", {0, kMostShift}};
    const Mouths tight = preset_value(TablePreset::kNineFootPro).mouths.value();
    for (const Mouths& mouths : {Mouths{}, wide_jaws(), tight}) {
        const Opening at_slow = opening_at(mouths, kSlow);
        const Opening at_medium = opening_at(mouths, kMedium);
        const Opening at_fast = opening_at(mouths, kFast);
        slow.ours.emplace_back(at_slow.width);
        medium.ours.emplace_back(at_slow.width - at_medium.width);
        fast.ours.emplace_back(at_medium.width - at_fast.width);
        shift.ours.emplace_back(std::abs(at_fast.middle - at_slow.middle));
    }
    width.rows = {slow};
    MeasuredTable speed = width;
    speed.name = "corner_pocket_by_speed";
    speed.title = "Corner pocket, along the rail: what speed changes";
    speed.reach = {};
    speed.note =
        "At 4 m/s a ball that the jaws throw out may still come back within the time that is "
        "looked at, which widens the pocket again.";
    speed.rows = {medium, fast, shift};
    return {width, speed};
}

}  // namespace poolhall::lab
