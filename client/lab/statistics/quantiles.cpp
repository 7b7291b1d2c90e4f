#include "client/lab/statistics/quantiles.hpp"

#include <algorithm>
#include <cstddef>

namespace poolhall::lab {

double quantile(std::span<const double> ascending, double p) {
    const double place = p * static_cast<double>(ascending.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const double low = ascending[below];
    const double part = place - static_cast<double>(below);
    // Not only quick: infinity less infinity is no number.
    if (part == 0) return low;
    return low + part * (ascending[below + 1] - low);
}

std::optional<Spread> spread_of(std::vector<double> values) {
    if (values.empty()) return std::nullopt;
    std::sort(values.begin(), values.end());
    return Spread{quantile(values, 0.5), quantile(values, 0.9), values.back()};
}

}  // namespace poolhall::lab
