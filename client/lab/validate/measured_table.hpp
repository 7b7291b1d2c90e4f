#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// A published measurement beside what our models give for it.
namespace poolhall::lab {

/// What a source says: one value, or from `low` to `high`.
struct Published {
    double low = 0;
    double high = 0;

    constexpr Published(double value) : low(value), high(value) {}  // NOLINT: a value is one

    constexpr Published(double least, double most) : low(least), high(most) {}

    [[nodiscard]] bool is_range() const { return low < high; }
};

struct MeasuredRow {
    std::string what;
    Published published;
    bool is_outlier = false;  ///< left out of `rms_without_outliers`
    /// By each of the table's models; nothing where a model does not apply.
    std::vector<std::optional<double>> ours = {};
};

/// One table of one source. All values in one unit.
struct MeasuredTable {
    std::string name;          ///< "two_balls_speed"
    std::string title;         ///< for people
    std::string unit;          ///< "m/s"
    std::string source;        ///< who measured it, and where it is published
    std::string accuracy;      ///< how exact the source is
    bool is_relative = false;  ///< errors are shares of the published value
    int digits = 3;            ///< behind the point, in print
    /// The rms error that a model should reach, in the unit or as a share.
    std::optional<double> reach = {};
    std::string note = {};  ///< what the residuals show
    std::vector<std::string> models = {};
    std::vector<MeasuredRow> rows = {};
};

/// Ours minus what was published; 0 within a published range, and outside it from its nearer end.
/// A share of that if the table says so.
[[nodiscard]] std::optional<double> error_of(const MeasuredTable& table, const MeasuredRow& row,
                                             std::size_t model);

struct TableErrors {
    std::optional<double> rms;                   ///< over all rows that the model applies to
    std::optional<double> rms_without_outliers;  ///< nothing where the table has none
};

[[nodiscard]] TableErrors errors_of(const MeasuredTable& table, std::size_t model);

}  // namespace poolhall::lab
