#include "client/lab/accuracy/orders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace poolhall::lab {

namespace {

/// Relative: Euler 1 +- 0.1, exact_arc 2 +- 0.2.
constexpr double kOrderTolerance = 0.1;

struct Quantity {
    std::string_view name;
    std::optional<double> (*median)(const AccuracyPoint& point);
};

std::optional<double> median_of(const std::optional<Spread>& spread) {
    return spread ? std::optional(spread->median) : std::nullopt;
}

constexpr std::string_view kImpactPlace = "impact_place_error";

constexpr std::array kQuantities{
    Quantity{"rest_error", [](const AccuracyPoint& p) { return median_of(p.rest_error); }},
    Quantity{"impact_time_error",
             [](const AccuracyPoint& p) { return median_of(p.impact_time_error); }},
    Quantity{kImpactPlace, [](const AccuracyPoint& p) { return median_of(p.impact_place_error); }},
    Quantity{"impact_velocity_error",
             [](const AccuracyPoint& p) { return median_of(p.impact_velocity_error); }},
    Quantity{"energy_drift", [](const AccuracyPoint& p) { return median_of(p.energy_drift); }},
};

constexpr std::array kStepping{SolverKind::kEuler, SolverKind::kSemiImplicit, SolverKind::kExactArc,
                               SolverKind::kOverlap};

/// By theory: explicit and semi-implicit Euler leave an error of the tick's square in each tick;
/// the contacts of exact_arc are found on chords, a tick's square away from the arc.
double expected_order(SolverKind solver) {
    return solver == SolverKind::kExactArc ? 2 : 1;
}

double floor_of(std::span<const AccuracyPoint> points, const Quantity& quantity) {
    double floor = kLeastFloor;
    for (const AccuracyPoint& point : points) {
        if (point.solver.kind != SolverKind::kEvent) continue;
        floor = std::max(floor, kFloorOverEvent * quantity.median(point).value_or(0));
    }
    return floor;
}

/// In ascending order of the rate; empty where a rate lacks the quantity.
std::vector<ErrorAtRate> errors_of(std::span<const AccuracyPoint> points, SolverKind solver,
                                   const Quantity& quantity) {
    std::vector<ErrorAtRate> errors;
    for (const AccuracyPoint& point : points) {
        if (point.solver.kind != solver) continue;
        const auto median = quantity.median(point);
        if (!median) return {};
        errors.push_back({point.solver.hz, *median});
    }
    return errors;
}

/// Why the order is not the one that theory expects.
std::string note_of(std::string_view quantity, std::span<const ErrorAtRate> errors, double floor,
                    const std::optional<Order>& order, double expected) {
    const auto rounded = std::count_if(errors.begin(), errors.end(),
                                       [&](const ErrorAtRate& at) { return at.error <= floor; });
    if (!order && rounded > 0 && quantity == kImpactPlace)
        return "exact but for rounding: up to there the way is straight";
    if (!order && rounded > 0) return "no more than rounding at most rates";
    if (!order) return "does not fall with a power of the tick at these rates";
    if (std::abs(order->order - expected) <= kOrderTolerance * expected) return "";
    if (order->low <= expected && expected <= order->high)
        return "too uncertain to tell from theory's";
    return "not theory's: from rate to rate the median shot takes another course";
}

}  // namespace

std::vector<OrderRow> fitted_orders(std::span<const AccuracyPoint> points) {
    std::vector<OrderRow> rows;
    for (const SolverKind solver : kStepping) {
        for (const Quantity& quantity : kQuantities) {
            const auto errors = errors_of(points, solver, quantity);
            if (errors.empty()) continue;
            const double floor = floor_of(points, quantity);
            const auto order = fitted_order(errors, floor);
            const double expected = expected_order(solver);
            rows.push_back({solver, std::string(quantity.name), order, expected,
                            note_of(quantity.name, errors, floor, order, expected)});
        }
    }
    return rows;
}

}  // namespace poolhall::lab
