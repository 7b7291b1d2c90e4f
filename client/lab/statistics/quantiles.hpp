#pragma once

#include <optional>
#include <span>
#include <vector>

namespace poolhall::lab {

/// The p-quantile, 0 <= p <= 1, of one or more numbers in ascending order, linear between them:
/// type 7 of Hyndman and Fan, "Sample Quantiles in Statistical Packages", The American Statistician
/// 50(4), 1996; what R and NumPy give by default.
[[nodiscard]] double quantile(std::span<const double> ascending, double p);

/// How numbers are spread, in their unit.
struct Spread {
    double median = 0;
    double p90 = 0;  ///< the 0.9-quantile
    double max = 0;

    friend bool operator==(const Spread&, const Spread&) = default;
};

/// Of the numbers in any order; nothing if there are none.
[[nodiscard]] std::optional<Spread> spread_of(std::vector<double> values);

}  // namespace poolhall::lab
