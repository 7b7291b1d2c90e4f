#pragma once

#include "client/lab/accuracy/results.hpp"

#include <span>
#include <vector>

namespace poolhall::lab {

/// The orders of convergence of every solver with ticks, in every quantity that all its rates have,
/// from the medians. The rounding floor of a quantity is kFloorOverEvent times the median of the
/// event solver, which has no other error, and kLeastFloor at least.
[[nodiscard]] std::vector<OrderRow> fitted_orders(std::span<const AccuracyPoint> points);

inline constexpr double kFloorOverEvent = 100;
inline constexpr double kLeastFloor = 1e-14;

}  // namespace poolhall::lab
