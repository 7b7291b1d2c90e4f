#include "client/lab/statistics/order_fit.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <cmath>
#include <vector>

namespace poolhall::lab {

namespace {

/// Whether the point is near the line through the others.
bool continues(std::span<const Point2> others, const Point2& point) {
    const auto [slope, standard_error, middle] = fit_line(others);
    const double expected = middle.y + slope * (point.x - middle.x);
    return std::abs(point.y - expected) <= std::log(kAsymptoticFactor);
}

/// The end of the points that is straight, kLeastOrderPoints at least.
std::span<const Point2> straight_end(std::span<const Point2> points) {
    std::size_t count = kLeastOrderPoints;
    while (count < points.size() &&
           continues(points.last(count), points[points.size() - count - 1]))
        ++count;
    return points.last(count);
}

/// The highest rates in a row whose errors are more than `floor`.
std::span<const ErrorAtRate> above_floor(std::span<const ErrorAtRate> points, double floor) {
    while (!points.empty() && !(points.back().error > floor))
        points = points.first(points.size() - 1);
    std::size_t count = 0;
    while (count < points.size() && points[points.size() - count - 1].error > floor)
        ++count;
    return points.last(count);
}

}  // namespace

LineFit fit_line(std::span<const Point2> points) {
    const auto count = static_cast<double>(points.size());
    Point2 mean;
    for (const Point2& point : points)
        mean = {mean.x + point.x / count, mean.y + point.y / count};
    double sum_xx = 0;
    double sum_xy = 0;
    for (const Point2& point : points) {
        sum_xx += (point.x - mean.x) * (point.x - mean.x);
        sum_xy += (point.x - mean.x) * (point.y - mean.y);
    }
    const double slope = sum_xy / sum_xx;
    double residual = 0;
    for (const Point2& point : points) {
        const double off = (point.y - mean.y) - slope * (point.x - mean.x);
        residual += off * off;
    }
    return {slope, std::sqrt(residual / (count - 2) / sum_xx), mean};
}

std::optional<Order> fitted_order(std::span<const ErrorAtRate> points, double floor) {
    const std::span<const ErrorAtRate> clear = above_floor(points, floor);
    std::vector<Point2> logs;
    for (const auto& [hz, error] : clear)
        logs.push_back({std::log(hz), std::log(error)});
    if (logs.size() < kLeastOrderPoints) return std::nullopt;
    const std::span<const Point2> range = straight_end(logs);
    const LineFit fit = fit_line(range);
    if (-fit.slope < kLeastOrder) return std::nullopt;
    const boost::math::students_t t(static_cast<double>(range.size() - 2));
    const double half = boost::math::quantile(t, 0.975) * fit.standard_error;
    const std::size_t first = logs.size() - range.size();
    return Order{-fit.slope,   -fit.slope - half, -fit.slope + half,
                 range.size(), clear[first].hz,   clear.back().hz};
}

}  // namespace poolhall::lab
