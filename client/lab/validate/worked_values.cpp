#include "client/lab/validate/cases.hpp"
#include "client/lab/validate/models.hpp"
#include "client/lab/validate/tables.hpp"

#include <array>

namespace poolhall::lab {

namespace {

/// Slow, medium and fast of TP A.14: 1, 3 and 7 mph, in m/s.
constexpr std::array kSpeeds{0.447, 1.341, 3.129};

struct Throw {
    double cut = 0;                                  ///< degrees
    double follow = 0;                               ///< 0 stun, 1 rolling
    double english = 0;                              ///< of the largest, half a radius
    std::array<double, kSpeeds.size()> throws = {};  ///< degrees
};

// TP A.14, e = 1, friction by its law.
constexpr std::array kThrows{
    Throw{5, 0, 0, {0.716, 0.716, 0.716}},   Throw{10, 0, 0, {1.443, 1.443, 1.443}},
    Throw{20, 0, 0, {2.976, 2.976, 2.500}},  Throw{30, 0, 0, {4.715, 3.549, 1.698}},
    Throw{45, 0, 0, {4.945, 2.773, 1.127}},  Throw{60, 0, 0, {4.621, 2.318, 0.895}},
    Throw{30, 1, 0, {2.186, 1.004, 0.388}},  Throw{0, 0, 0.25, {2.556, 2.556, 2.556}},
    Throw{0, 0, 0.5, {5.102, 3.053, 1.307}}, Throw{0, 0, 1, {3.933, 1.569, 0.658}},
};

constexpr double kHalfBall = 30;  ///< degrees of cut

TwoBallCase half_ball(double e, double mu, double follow) {
    TwoBallCase one;
    one.impact = with_friction(e, mu);
    one.cut = kHalfBall * kDegree;
    one.follow = follow;
    return one;
}

TwoBallCase case_of(const Throw& row, double speed) {
    TwoBallCase one;
    one.impact = with_alciatores_law(1);
    one.speed = speed;
    one.cut = row.cut * kDegree;
    one.follow = row.follow;
    // The spin of an offset b is 5/2 v b / R^2 (TP A.12); the largest b is R/2.
    one.english = 1.25 * row.english;
    return one;
}

std::string words_of(const Throw& row, double speed) {
    const auto whole = [](double value) { return std::to_string(static_cast<int>(value + 0.5)); };
    const std::string how =
        row.english > 0 ? "straight, " + whole(100 * row.english) + " % english"
                        : whole(row.cut) + " deg cut, " + (row.follow > 0 ? "rolling" : "stun");
    return "throw, " + how + ", " + std::to_string(speed).substr(0, 5) + " m/s";
}

MeasuredTable table_of(std::string name, std::string title, std::string unit) {
    return {.name = std::move(name),
            .title = std::move(title),
            .unit = std::move(unit),
            .source = "TP 3.3, A.5, A.6, A.14 (Alciatore)",
            .accuracy = "formulas; printed to the last digit",
            .digits = 4,
            .models = {"event solver"}};
}

void add_half_balls(std::vector<MeasuredRow>& rows) {
    const TwoBallOutcome stun = just_after(half_ball(0.94, 0.06, 0));
    const double thrown = stun.object_angle / kDegree + kHalfBall;
    const double cue = stun.cue_angle / kDegree;
    rows.push_back({"TP A.5, stun, half ball, e 0.94, mu 0.06: throw", 3.434, false, {thrown}});
    rows.push_back({"the same: cue ball off the tangent", 3.307, false, {90 - kHalfBall - cue}});
    rows.push_back(
        {"the same: angle between the balls", 83.259, false, {cue + kHalfBall - thrown}});
    for (const auto& [e, published] : {std::pair{1.0, 33.670}, std::pair{0.94, 31.988}}) {
        const double angle = after_slip(half_ball(e, 0, 1)).cue_angle / kDegree;
        const std::string where = e == 1 ? "TP 3.3, e 1" : "TP A.6, e 0.94";
        rows.push_back({where + ", rolling, half ball: cue ball turns", published, false, {angle}});
    }
}

}  // namespace

std::vector<MeasuredTable> worked_value_tables() {
    MeasuredTable angles = table_of("worked_angles", "Formulas with worked values: angles", "deg");
    angles.reach = 0.001;
    add_half_balls(angles.rows);
    for (const Throw& row : kThrows) {
        for (std::size_t i = 0; i < kSpeeds.size(); ++i)
            angles.rows.push_back({words_of(row, kSpeeds[i]),
                                   row.throws[i],
                                   false,
                                   {throw_of(case_of(row, kSpeeds[i])) / kDegree}});
    }
    MeasuredTable speed = table_of("worked_speed", "Formulas with worked values: speed", "v");
    speed.reach = 1e-4;
    speed.rows.push_back({"TP 3.3, rolling, half ball: cue ball keeps",
                          0.5579,
                          false,
                          {after_slip(half_ball(1, 0, 1)).cue_speed}});
    return {angles, speed};
}

}  // namespace poolhall::lab
