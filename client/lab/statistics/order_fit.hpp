#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace poolhall::lab {

/// A straight line through points by least squares.
struct LineFit {
    double slope = 0;
    double standard_error = 0;  ///< of the slope
};

struct Point2 {
    double x = 0;
    double y = 0;
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
inline constexpr double kLeastLocalOrder = 0.5;
inline constexpr double kLocalOrderScatter = 0.35;

/// The order of convergence: the slope of log error over log hz by least squares, with Student's t
/// interval for a slope (Draper and Smith, "Applied Regression Analysis", 1.4). The points are in
/// ascending order of hz. Taken are only those in the asymptotic range:
///
/// - those from the first rate on at which the error is `floor` or less are left out: there it is
///   rounding;
/// - the local order between two neighbours is log(error / next error) / log(next hz / hz). The
///   range begins at the highest rate that is left and goes down as long as the local order is
///   within kLocalOrderScatter of the median of the three highest: below it, steps are too long for
///   the error's leading term to rule.
///
/// Nothing if that median is below kLeastLocalOrder (the error does not fall) or fewer than
/// kLeastOrderPoints points are left.
[[nodiscard]] std::optional<Order> fitted_order(std::span<const ErrorAtRate> points, double floor);

}  // namespace poolhall::lab
