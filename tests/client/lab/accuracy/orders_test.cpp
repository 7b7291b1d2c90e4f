#include "client/lab/accuracy/orders.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string_view>
#include <vector>

namespace poolhall::lab {
namespace {

Spread all(double value) {
    return {value, value, value};
}

/// A solver at 15 to 7680 Hz whose rest error falls with a power of the tick.
std::vector<AccuracyPoint> points_of(SolverKind solver, double power) {
    std::vector<AccuracyPoint> points;
    for (double hz = 15; hz <= 7680; hz *= 2) {
        AccuracyPoint& point = points.emplace_back();
        point.solver = {solver, hz};
        point.rest_error = all(std::pow(hz, -power));
        point.impact_place_error = all(1e-16);
        point.energy_drift = all(0.5);
    }
    return points;
}

OrderRow row_of(const std::vector<OrderRow>& rows, std::string_view quantity) {
    return *std::find_if(rows.begin(), rows.end(),
                         [&](const OrderRow& row) { return row.quantity == quantity; });
}

TEST(Orders, OfASolverThatDoesWhatTheorySays) {
    for (const auto& [solver, power] :
         {std::pair{SolverKind::kEuler, 1.0}, {SolverKind::kExactArc, 2.0}}) {
        const auto rows = fitted_orders(points_of(solver, power));
        const OrderRow row = row_of(rows, "rest_error");
        EXPECT_EQ(row.solver, solver);
        EXPECT_NEAR(row.order->order, power, 1e-12);
        EXPECT_EQ(row.expected, power);
        EXPECT_EQ(row.note, "");
    }
}

TEST(Orders, SayWhyThereIsNone) {
    const auto rows = fitted_orders(points_of(SolverKind::kEuler, 1));
    EXPECT_FALSE(row_of(rows, "impact_place_error").order);
    EXPECT_EQ(row_of(rows, "impact_place_error").note,
              "exact but for rounding: up to there the way is straight");
    EXPECT_FALSE(row_of(rows, "energy_drift").order);
    EXPECT_EQ(row_of(rows, "energy_drift").note,
              "does not fall with a power of the tick at these rates");
    // No shot had the true first impact.
    EXPECT_EQ(rows.size(), 3U);
}

TEST(Orders, SayThatTheyAreNotTheorys) {
    const auto rows = fitted_orders(points_of(SolverKind::kExactArc, 1));
    EXPECT_EQ(row_of(rows, "rest_error").note,
              "not theory's: from rate to rate the median shot takes another course");
}

TEST(Orders, StopWhereTheEventSolversOwnErrorShows) {
    auto points = points_of(SolverKind::kEuler, 1);
    AccuracyPoint& event = points.emplace_back();
    event.solver.kind = SolverKind::kEvent;
    event.rest_error = all(1e-5);
    const auto rows = fitted_orders(points);
    EXPECT_EQ(row_of(rows, "rest_error").order->to_hz, 960);
}

}  // namespace
}  // namespace poolhall::lab
