#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace poolhall::lab {

struct Point2 {
    double x = 0;
    double y = 0;
};

/// A straight line through points by least squares.
struct LineFit {
    double slope = 0;
    double standard_error = 0;  ///< of the slope
    Point2 middle;              ///< a point of the line: the mean of the points
};

/// Through at least three points, not all with one x.
[[nodiscard]] LineFit fit_line(std::span<const Point2> points);

/// How large an error is at a rate.
struct ErrorAtRate {
    double hz = 0;     ///< ticks a second
    double error = 0;  ///< in any unit
};

/// By which power of the tick an error falls: error ~ hz^-order.
struct Order {
    double order = 0;
    double low = 0;   ///< of the interval that holds it with a confidence of 95 %
    double high = 0;  ///< of the same
    std::size_t points = 0;
    double from_hz = 0;  ///< the lowest and the highest rate that were taken
    double to_hz = 0;
};

inline constexpr std::size_t kLeastOrderPoints = 4;
inline constexpr double kLeastOrder = 0.5;
inline constexpr double kAsymptoticFactor = 1.4;

/// The order of convergence: the slope of log error over log hz by least squares, with Student's t
/// interval for a slope (Draper and Smith, "Applied Regression Analysis", 1.4). The points are in
/// ascending order of hz. Taken are only those in the asymptotic range:
///
/// - the highest rates at which the error is `floor` or less are left out: there it is rounding;
/// and
///   all below a lower rate at which it is;
/// - of those left, the range begins with the kLeastOrderPoints highest rates and goes down as long
///   as the next lower rate's error is within a factor of kAsymptoticFactor of what a line through
///   those taken so far says of it: below, steps are too long for the error's leading term to rule.
///
/// Nothing if fewer than kLeastOrderPoints are left, or the order is below kLeastOrder: such an
/// error does not fall with a power of the tick.
[[nodiscard]] std::optional<Order> fitted_order(std::span<const ErrorAtRate> points, double floor);

}  // namespace poolhall::lab
