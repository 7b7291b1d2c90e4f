#pragma once

#include "shared/physics/scene/scene.hpp"

#include <optional>
#include <string_view>

namespace poolhall::lab {

/// "event", "euler:30", "semi_implicit:120", ...: a kind, and the ticks a second of those that have
/// ticks, 30 if left out. Nothing if the text is none of these.
[[nodiscard]] std::optional<SolverSpec> parse_solver(std::string_view text);

}  // namespace poolhall::lab
