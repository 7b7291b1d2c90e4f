#include "client/lab/validate/cases.hpp"
#include "client/lab/validate/diamonds.hpp"
#include "client/lab/validate/models.hpp"
#include "client/lab/validate/tables.hpp"

#include <array>

namespace poolhall::lab {

namespace {

// WPA equipment specifications, 8: from the head spot through the foot spot, firm, a ball goes 4 to
// 4.5 lengths of the table.
constexpr Published kFirm{2.5, 5};  ///< m/s, what people call firm
constexpr double kLengths = 4.25;

// Corner-5, calibrated at its first line; within half a diamond at the others.
constexpr DiamondLine kCalibrated{5, 3};
constexpr std::array kCornerLines{DiamondLine{4.5, 2}, DiamondLine{6, 3}};
constexpr double kHalfADiamond = 0.5;

/// Sights stand 3 11/16 in behind the nose; a slow one-rail kick is a mirror there, mm.
constexpr double kSights = 93.7;

// Alciatore: a rolling cue ball turns by about 30 degrees from a quarter ball to three quarters.
constexpr Published kThirtyDegrees{27, 34};

struct Fullness {
    const char* name = "";
    double cut = 0;  ///< degrees
};

constexpr std::array kFullness{Fullness{"quarter ball", 48.59}, Fullness{"half ball", 30},
                               Fullness{"three-quarter ball", 14.48}};

MeasuredTable rail_speed_table() {
    MeasuredTable table{.name = "rail_speed",
                        .title = "Speed of a centre hit for 4.25 lengths",
                        .unit = "m/s",
                        .source = "WPA equipment specifications, 8; what is firm: players",
                        .accuracy = "loose",
                        .digits = 2,
                        .note =
                            "The preset's e(v) falls above 3.5 m/s, where nobody has measured it: "
                            "fast balls lose more than they do on a table.",
                        .models = names_of(pool_noses())};
    MeasuredRow row{"4.25 lengths", kFirm};
    for (const NoseModel& model : pool_noses())
        row.ours.emplace_back(speed_for_lengths(model.rail, kLengths));
    table.rows.push_back(std::move(row));
    return table;
}

MeasuredTable corner_table() {
    MeasuredTable table{.name = "corner_5",
                        .title = "Corner-5, with the side that makes 5 - 3 come to 2",
                        .unit = "diamonds",
                        .source = "players' diamond system",
                        .accuracy = "half a diamond",
                        .digits = 2,
                        .models = names_of(pool_noses())};
    for (const DiamondLine& line : kCornerLines) {
        const double third = line.origin - line.first;
        const auto text = [](double value) { return std::to_string(value).substr(0, 3); };
        MeasuredRow row{text(line.origin) + " - " + text(line.first),
                        {third - kHalfADiamond, third + kHalfADiamond}};
        for (const NoseModel& model : pool_noses()) {
            const auto side =
                side_for(model.rail, kCalibrated, kCalibrated.origin - kCalibrated.first);
            row.ours.push_back(side ? third_rail(model.rail, line, *side) : std::nullopt);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

MeasuredTable kick_table() {
    MeasuredTable table{.name = "kick",
                        .title = "Where the mirror of a slow one-rail kick is, behind the nose",
                        .unit = "mm",
                        .source = "players: the sights' line",
                        .accuracy = "loose",
                        .digits = 1,
                        .models = names_of(pool_noses())};
    for (const int degrees : {30, 45, 60}) {
        MeasuredRow row{std::to_string(degrees) + " deg from the normal", kSights};
        for (const NoseModel& model : pool_noses())
            row.ours.emplace_back(1000 * mirror_depth(model.rail, degrees * kDegree));
        table.rows.push_back(std::move(row));
    }
    return table;
}

MeasuredTable thirty_degree_table() {
    MeasuredTable table{.name = "thirty_degrees",
                        .title = "How far a rolling cue ball turns",
                        .unit = "deg",
                        .source = "30-degree rule, TP 3.3 (Alciatore)",
                        .accuracy = "27 to 34 degrees",
                        .digits = 2,
                        .models = names_of(ball_models())};
    for (const Fullness& fullness : kFullness) {
        MeasuredRow row{fullness.name, kThirtyDegrees};
        for (const BallModel& model : ball_models()) {
            TwoBallCase one{.impact = model.spec, .cut = fullness.cut * kDegree};
            row.ours.emplace_back(after_slip(one).cue_angle / kDegree);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace

std::vector<MeasuredTable> practice_tables() {
    return {rail_speed_table(), corner_table(), kick_table(), thirty_degree_table()};
}

}  // namespace poolhall::lab
