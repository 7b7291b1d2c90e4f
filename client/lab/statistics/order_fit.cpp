#include "client/lab/statistics/order_fit.hpp"

#include "client/lab/statistics/quantiles.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace poolhall::lab {

namespace {

/// Between each point and the next.
std::vector<double> local_orders(std::span<const Point2> logs) {
    std::vector<double> orders;
    for (std::size_t i = 1; i < logs.size(); ++i)
        orders.push_back((logs[i - 1].y - logs[i].y) / (logs[i].x - logs[i - 1].x));
    return orders;
}

double median_of_highest(const std::vector<double>& orders) {
    const auto count = std::min<std::ptrdiff_t>(3, std::ssize(orders));
    return spread_of({orders.end() - count, orders.end()})->median;
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
    return {slope, std::sqrt(residual / (count - 2) / sum_xx)};
}

std::optional<Order> fitted_order(std::span<const ErrorAtRate> points, double floor) {
    std::vector<Point2> logs;
    for (const auto& [hz, error] : points) {
        if (!(error > floor)) break;
        logs.push_back({std::log(hz), std::log(error)});
    }
    if (logs.size() < kLeastOrderPoints) return std::nullopt;
    const std::vector<double> orders = local_orders(logs);
    const double usual = median_of_highest(orders);
    if (usual < kLeastLocalOrder) return std::nullopt;
    std::size_t first = orders.size();
    while (first > 0 && std::abs(orders[first - 1] - usual) <= kLocalOrderScatter)
        --first;
    const std::span<const Point2> range = std::span(logs).subspan(first);
    if (range.size() < kLeastOrderPoints) return std::nullopt;
    const auto [slope, standard_error] = fit_line(range);
    const boost::math::students_t t(static_cast<double>(range.size() - 2));
    const double half = boost::math::quantile(t, 0.975) * standard_error;
    return Order{-slope,       -slope - half,    -slope + half,
                 range.size(), points[first].hz, points[first + range.size() - 1].hz};
}

}  // namespace poolhall::lab
