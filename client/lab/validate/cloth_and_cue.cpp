#include "client/lab/validate/cases.hpp"
#include "client/lab/validate/models.hpp"
#include "client/lab/validate/tables.hpp"
#include "shared/physics/contact/ball_friction.hpp"
#include "shared/physics/motion/cue.hpp"
#include "shared/physics/simulate.hpp"
#include "shared/table/presets.hpp"

#include <array>
#include <cmath>

namespace poolhall::lab {

namespace {

constexpr const char* kThrowSource =
    "BD September 2006: 13 cuts, 3 speeds, 3 shots each (second hand)";
constexpr const char* kThrowAccuracy = "hand-shot; about half a degree";
constexpr double kSlow = 0.447;  ///< m/s, like the next the speeds of TP A.14
constexpr double kMedium = 1.341;
constexpr double kFast = 3.129;

constexpr double kThrowAtTen = 1.5;    ///< degrees, at a cut of 10, stun, any speed
constexpr double kLargestThrow = 5.8;  ///< degrees, slow stun
constexpr double kCutOfLargest = 35;   ///< degrees
constexpr double kFastOverSlow = 0.5;  ///< at a cut of 30, less than that

struct Cue {
    const char* name = "";
    double offset = 0;  ///< of the tip, in radii
    double squirt = 0;  ///< degrees
    double mass = 0;    ///< of the ball over the cue's end: the one number that was fitted to it
};

// TP B.1 (second hand).
constexpr std::array kCues{Cue{"plain cue", 0.453, 2.5, 20.15},
                           Cue{"low-deflection cue", 0.453, 1.8, 29.16},
                           Cue{"break cue", 0.267, 2.4, 12.01}};

struct SlipFriction {
    double slip = 0;  ///< m/s
    double mu = 0;
};

// Marlow, The Physics of Pocket Billiards, 1995, table 10 (second hand).
constexpr std::array kFrictions{SlipFriction{0.0707, 0.11}, SlipFriction{0.707, 0.06},
                                SlipFriction{7.07, 0.01}};

double thrown(const BallModel& model, double speed, double cut) {
    TwoBallCase one{.impact = model.spec, .speed = speed, .cut = cut * kDegree, .follow = 0};
    return throw_of(one) / kDegree;
}

/// Degrees of cut, by tenths, at which a slow stun shot throws most.
double cut_of_largest(const BallModel& model) {
    double best = 0;
    for (int tenth = 1; tenth < 900; ++tenth) {
        if (thrown(model, kSlow, tenth / 10.0) > thrown(model, kSlow, best)) best = tenth / 10.0;
    }
    return best;
}

std::vector<MeasuredTable> throw_tables() {
    MeasuredTable angles{.name = "throw",
                         .title = "Throw of the object ball, stun",
                         .unit = "deg",
                         .source = kThrowSource,
                         .accuracy = kThrowAccuracy,
                         .digits = 2,
                         .models = names_of(throwing_models())};
    MeasuredTable ratio = angles;
    ratio.name = "throw_by_speed";
    ratio.title = "Throw at a cut of 30 degrees, fast over slow";
    ratio.unit = "";
    MeasuredRow ten{"10 deg cut, slow", kThrowAtTen};
    MeasuredRow ten_fast{"10 deg cut, fast", kThrowAtTen};
    MeasuredRow most{"the largest, slow", kLargestThrow};
    MeasuredRow cut{"the cut of the largest", kCutOfLargest};
    MeasuredRow share{"3.129 over 0.447 m/s", {0, kFastOverSlow}};
    for (const BallModel& model : throwing_models()) {
        ten.ours.emplace_back(thrown(model, kSlow, 10));
        ten_fast.ours.emplace_back(thrown(model, kFast, 10));
        cut.ours.emplace_back(cut_of_largest(model));
        most.ours.emplace_back(thrown(model, kSlow, *cut.ours.back()));
        share.ours.emplace_back(thrown(model, kFast, 30) / thrown(model, kSlow, 30));
    }
    angles.rows = {ten, ten_fast, most, cut};
    ratio.rows = {share};
    return {angles, ratio};
}

/// Degrees by which the ball leaves the line of a level cue.
double squirt_of(double offset, double ball_over_end) {
    Scene scene;
    scene.table.rails = false;
    scene.effects.sliding = SlidingSpec{};
    scene.solver.kind = SolverKind::kEvent;
    scene.balls = {{"cue", {}}};
    scene.strike = Strike{BallIndex{0}, {1, 0}, 1, {offset, 0}};
    scene.strike->end_mass_ratio = 1 / ball_over_end;
    scene.limits.events = 1;
    const Vec3 v = simulate(scene).events.at(0).after[0].v;
    return std::abs(std::atan2(v.y, v.x)) / kDegree;
}

MeasuredTable squirt_table() {
    MeasuredTable table{.name = "squirt",
                        .title = "Squirt, one end mass fitted for each cue",
                        .unit = "deg",
                        .source = "TP B.1 (second hand)",
                        .accuracy = "a tenth of a degree",
                        .note = "A calibration: it shows that the formula can give these values.",
                        .models = {"TP A.31"}};
    for (const Cue& cue : kCues) {
        const std::string where = std::to_string(cue.offset).substr(0, 5) + " R";
        table.rows.push_back(
            {cue.name + (", " + where), cue.squirt, false, {squirt_of(cue.offset, cue.mass)}});
    }
    return table;
}

/// Speed of the ball over that of a cue that hits it in its middle.
double speed_ratio(CuePreset preset) {
    Strike strike{BallIndex{0}, {1, 0}, 1};
    strike.cue = preset_value(preset);
    return strike_of_ball(strike, preset_value(BallSet::kWpa)).speed;
}

MeasuredTable cue_speed_table() {
    MeasuredTable table{.name = "cue_speed",
                        .title = "Speed of the ball over that of the cue, centre hit",
                        .unit = "V",
                        .source =
                            "Alciatore (second hand): leather tips of e 0.71 to 0.75, phenolic "
                            "ones of 0.81 to 0.87",
                        .accuracy = "two digits",
                        .models = {"cue by preset"}};
    table.rows = {{"leather tip", {1.27, 1.33}, false, {speed_ratio(CuePreset::kPlain)}},
                  {"phenolic tip", {1.35, 1.4}, false, {speed_ratio(CuePreset::kBreak)}}};
    return table;
}

MeasuredTable friction_table() {
    MeasuredTable table{.name = "ball_friction",
                        .title = "Friction between balls, by the speed of their slip",
                        .unit = "",
                        .source = "Marlow, The Physics of Pocket Billiards, 1995 (second hand)",
                        .accuracy = "two digits",
                        .models = {"Alciatore's law", "mu 0.05"}};
    for (const SlipFriction& row : kFrictions) {
        MeasuredRow line{std::to_string(row.slip).substr(0, 4) + " m/s", row.mu};
        for (const BallBallSpec& spec : {with_alciatores_law(1), with_friction(1, 0.05)})
            line.ours.emplace_back(BallFriction(spec).coefficient(row.slip));
        table.rows.push_back(std::move(line));
    }
    return table;
}

Figure throw_figure() {
    Figure figure{
        "throw",
        "Throw of the object ball against the cut, stun",
        "Lines: Alciatore's law, e 0.95, at 0.447, 1.341 and 3.129 m/s. Points: Billiards "
        "Digest, September 2006.",
        "cut (degrees)",
        "throw (degrees)",
        {{"measured, any speed", true, true, {10}, {kThrowAtTen}},
         {"measured, largest, slow", true, true, {kCutOfLargest}, {kLargestThrow}}}};
    const BallModel law{"", with_alciatores_law(0.95)};
    for (const auto& [name, speed] :
         {std::pair{"slow", kSlow}, std::pair{"medium", kMedium}, std::pair{"fast", kFast}}) {
        Curve curve{name, false, false, {}, {}};
        for (int cut = 0; cut <= 80; ++cut) {
            curve.x.push_back(cut);
            curve.y.push_back(thrown(law, speed, cut));
        }
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

Figure squirt_figure() {
    Figure figure{
        "squirt",
        "Squirt against the offset of the tip",
        "One number for each cue, the mass of its end, is fitted to the one point that was "
        "measured.",
        "offset (radii)",
        "squirt (degrees)",
        {}};
    for (const Cue& cue : kCues) {
        figure.curves.push_back(
            {std::string("measured, ") + cue.name, true, true, {cue.offset}, {cue.squirt}});
        Curve curve{cue.name, false, false, {}, {}};
        for (int hundredth = 0; hundredth <= 55; ++hundredth) {
            curve.x.push_back(hundredth / 100.0);
            curve.y.push_back(squirt_of(hundredth / 100.0, cue.mass));
        }
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

}  // namespace

std::vector<MeasuredTable> cloth_and_cue_tables() {
    std::vector<MeasuredTable> tables = throw_tables();
    tables.push_back(squirt_table());
    tables.push_back(cue_speed_table());
    tables.push_back(friction_table());
    return tables;
}

std::vector<Figure> cloth_and_cue_figures() {
    return {throw_figure(), squirt_figure()};
}

}  // namespace poolhall::lab
