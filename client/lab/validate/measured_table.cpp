#include "client/lab/validate/measured_table.hpp"

#include <algorithm>
#include <cmath>

namespace poolhall::lab {

namespace {

std::optional<double> rms_of(const MeasuredTable& table, std::size_t model, bool outliers) {
    double sum = 0;
    int count = 0;
    for (const MeasuredRow& row : table.rows) {
        const auto error = error_of(table, row, model);
        if (!error || (row.is_outlier && !outliers)) continue;
        sum += *error * *error;
        ++count;
    }
    return count == 0 ? std::nullopt : std::optional(std::sqrt(sum / count));
}

}  // namespace

std::optional<double> error_of(const MeasuredTable& table, const MeasuredRow& row,
                               std::size_t model) {
    const auto& ours = row.ours[model];
    if (!ours) return std::nullopt;
    const double nearest = std::clamp(*ours, row.published.low, row.published.high);
    const double error = *ours - nearest;
    return table.is_relative ? error / nearest : error;
}

TableErrors errors_of(const MeasuredTable& table, std::size_t model) {
    const bool has_outlier = std::any_of(table.rows.begin(), table.rows.end(),
                                         [](const MeasuredRow& row) { return row.is_outlier; });
    return {rms_of(table, model, true),
            has_outlier ? rms_of(table, model, false) : std::optional<double>()};
}

}  // namespace poolhall::lab
