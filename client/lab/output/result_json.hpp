#pragma once

#include "client/lab/output/build_info.hpp"
#include "client/lab/statistics/quantiles.hpp"

#include <nlohmann/json.hpp>
#include <optional>

// What the result files of accuracy and effects have in common. Nothing is null.
namespace poolhall::lab {

using Json = nlohmann::ordered_json;

[[nodiscard]] inline Json json_of(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

[[nodiscard]] inline Json json_of(const std::optional<Spread>& spread) {
    if (!spread) return {};
    return {{"median", spread->median}, {"p90", spread->p90}, {"max", spread->max}};
}

[[nodiscard]] inline Json json_of(const BuildInfo& build) {
    return {{"compiler", build.compiler}, {"flags", build.flags}, {"cpu", build.processor}};
}

}  // namespace poolhall::lab
