#include "client/lab/validate/cases.hpp"
#include "client/lab/validate/models.hpp"
#include "client/lab/validate/rail_ratio.hpp"
#include "client/lab/validate/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace poolhall::lab {

namespace {

constexpr const char* kSource = "M09: 31 shots of 0.28 to 3.5 m/s, square, rolling; snooker";
constexpr std::array kSpeeds{0.3, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5};  ///< m/s
constexpr double kRigidUpTo = 2.5;  ///< m/s along the normal, M10: there a cushion seems rigid

/// M09's quadratic through the 31 shots: speed just after the impact, m/s.
double measured_rebound(double v) {
    return -0.0877 * v * v + 1.131 * v - 0.0953;
}

/// Share of the speed that is left when the slip after a square impact has ended: Marlow, 1995.
constexpr double kMarlowsShare = 0.55;

/// M10, in words: the loss is largest near 40 degrees; angles hardly depend on the speed.
constexpr double kLargestLossAt = 40;

struct SpeedBin {
    double low = 0;    ///< m/s
    double high = 0;   ///< m/s
    double ratio = 0;  ///< the median
    int hits = 0;
};

// 442 hits of 182 three-cushion shots that were recorded at 50 Hz: speed along the rail's normal
// after it over that before, each by a straight line through five samples, slip included.
constexpr std::array kRatios{
    SpeedBin{0.25, 0.5, 0.634, 19}, SpeedBin{0.5, 0.75, 0.699, 30}, SpeedBin{0.75, 1, 0.738, 72},
    SpeedBin{1, 1.5, 0.766, 159},   SpeedBin{1.5, 2, 0.789, 84},    SpeedBin{2, 2.5, 0.796, 30},
    SpeedBin{2.5, 3.2, 0.792, 28},  SpeedBin{3.2, 4.5, 0.753, 17},
};

RailCase square(const NoseModel& model, double speed) {
    return {.ball = kSnookerBall, .rail = model.rail, .speed = speed};
}

MeasuredTable rebound_table(std::string name, std::string title, double fastest) {
    MeasuredTable table{.name = std::move(name),
                        .title = std::move(title),
                        .unit = "m/s",
                        .source = kSource,
                        .accuracy = "places to 0.25 mm; the quadratic that fits the shots",
                        .reach = 0.02,
                        .models = names_of(snooker_noses())};
    for (const double v : kSpeeds) {
        if (v > fastest) break;
        MeasuredRow row{std::to_string(v).substr(0, 3) + " m/s", measured_rebound(v)};
        for (const NoseModel& model : snooker_noses())
            row.ours.emplace_back(just_after(square(model, v)).speed);
        table.rows.push_back(std::move(row));
    }
    return table;
}

MeasuredTable after_slip_table() {
    MeasuredTable table{.name = "rebound_after_slip",
                        .title = "Square rebound: speed left when the slip has ended",
                        .unit = "v",
                        .source = "Marlow, The Physics of Pocket Billiards, 1995 (second hand)",
                        .accuracy = "two digits",
                        .models = names_of(snooker_noses())};
    MeasuredRow row{"1.0 m/s", kMarlowsShare};
    for (const NoseModel& model : snooker_noses())
        row.ours.emplace_back(after_slip(square(model, 1)).speed);
    table.rows.push_back(std::move(row));
    return table;
}

/// Degrees from the rail at which a rolling ball of 1 m/s loses most.
double angle_of_largest_loss(const NoseModel& model) {
    double best = 0;
    double least = 1;
    for (int degrees = 5; degrees <= 90; ++degrees) {
        RailCase one = square(model, 1);
        one.incidence = (90 - degrees) * kDegree;
        const double left = just_after(one).speed;
        if (left >= least) continue;
        least = left;
        best = degrees;
    }
    return best;
}

/// How much the rebound angle at 45 degrees changes from 0.5 to 2.5 m/s, degrees.
double change_of_angle(const NoseModel& model) {
    RailCase slow = square(model, 0.5);
    RailCase fast = square(model, kRigidUpTo);
    slow.incidence = fast.incidence = 45 * kDegree;
    return std::abs(just_after(fast).angle - just_after(slow).angle) / kDegree;
}

MeasuredTable oblique_table() {
    MeasuredTable table{.name = "rebound_oblique",
                        .title = "Oblique rebound of a rolling ball",
                        .unit = "deg",
                        .source = "M10, in words",
                        .accuracy = "read off figures: some degrees",
                        .digits = 1,
                        .models = names_of(snooker_noses())};
    MeasuredRow loss{"largest loss, from the rail", {kLargestLossAt - 5, kLargestLossAt + 5}};
    MeasuredRow change{"angle at 45 deg, 0.5 against 2.5 m/s", {0, 2}};
    for (const NoseModel& model : snooker_noses()) {
        loss.ours.emplace_back(angle_of_largest_loss(model));
        change.ours.emplace_back(change_of_angle(model));
    }
    table.rows = {loss, change};
    return table;
}

MeasuredTable ratio_table() {
    MeasuredTable table{.name = "rail_ratio",
                        .title = "Speed along the normal after a rail over that before",
                        .unit = "",
                        .source = "442 hits of 182 recorded three-cushion shots (61.5 mm balls)",
                        .accuracy =
                            "medians of 17 to 159 hits, of any angle and spin; "
                            "ours is a square hit of a rolling ball",
                        .models = names_of(carom_noses())};
    for (const SpeedBin& bin : kRatios) {
        const std::string range =
            std::to_string(bin.low).substr(0, 4) + " to " + std::to_string(bin.high).substr(0, 4);
        MeasuredRow row{range + " m/s, " + std::to_string(bin.hits) + " hits", bin.ratio};
        for (const NoseModel& model : carom_noses())
            row.ours.emplace_back(rail_ratio(model.rail, (bin.low + bin.high) / 2));
        table.rows.push_back(std::move(row));
    }
    return table;
}

Figure rebound_figure() {
    Figure figure{"rebound",
                  "A rolling ball square into a rail: speed just after against speed before",
                  "Measured: the quadratic through 31 shots of snooker balls (M09).",
                  "speed before (m/s)",
                  "speed just after (m/s)",
                  {{"measured, M09", true, false, {}, {}}}};
    for (const NoseModel& model : snooker_noses())
        figure.curves.push_back({model.name, false, false, {}, {}});
    for (int tenth = 3; tenth <= 35; ++tenth) {
        const double v = tenth / 10.0;
        for (Curve& curve : figure.curves)
            curve.x.push_back(v);
        figure.curves[0].y.push_back(measured_rebound(v));
        for (std::size_t i = 0; i < snooker_noses().size(); ++i)
            figure.curves[i + 1].y.push_back(just_after(square(snooker_noses()[i], v)).speed);
    }
    return figure;
}

Figure ratio_figure() {
    Figure figure{"rail_ratio",
                  "Speed along the normal after a rail over that before, by speed",
                  "Measured: medians over 442 hits of recorded three-cushion shots, slip included. "
                  "Ours: a square hit of a rolling ball, by the same estimator.",
                  "normal speed before (m/s)",
                  "after / before",
                  {{"measured", true, true, {}, {}}}};
    for (const SpeedBin& bin : kRatios) {
        figure.curves[0].x.push_back((bin.low + bin.high) / 2);
        figure.curves[0].y.push_back(bin.ratio);
    }
    for (const NoseModel& model : carom_noses()) {
        Curve curve{model.name, false, false, figure.curves[0].x, {}};
        for (const double v : curve.x)
            curve.y.push_back(rail_ratio(model.rail, v));
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

}  // namespace

std::vector<MeasuredTable> cushion_tables() {
    return {rebound_table("square_rebound", "Square rebound, 0.3 to 3.5 m/s", kSpeeds.back()),
            rebound_table("square_rebound_slow", "Square rebound, up to 2.5 m/s", kRigidUpTo),
            after_slip_table(), oblique_table(), ratio_table()};
}

std::vector<Figure> cushion_figures() {
    return {rebound_figure(), ratio_figure()};
}

}  // namespace poolhall::lab
