#pragma once

#include "shared/physics/scene/scene.hpp"

#include <optional>
#include <string>

// The parts of check(). Each names the first thing that is wrong.
namespace poolhall::scene_checks {

// Bounds wide enough for any experiment that makes sense, narrow enough that squares stay finite.
inline constexpr Real kMaxLength = 1e6;  ///< m; also kg, m/s^2 and s where nothing else bounds
inline constexpr Real kMaxSpeed = 1e6;   ///< m/s
inline constexpr Real kMaxSpin = 1e9;    ///< rad/s
inline constexpr Real kMaxFriction = 10;

using MaybeError = std::optional<SceneError>;

/// low <= x <= high; NaN is not.
[[nodiscard]] MaybeError in_range(Real x, Real low, Real high, const std::string& pointer);
/// 0 < x <= high.
[[nodiscard]] MaybeError positive(Real x, Real high, const std::string& pointer);

[[nodiscard]] MaybeError check_effects(const Scene& scene);
/// The table must have passed.
[[nodiscard]] MaybeError check_balls(const Scene& scene);

}  // namespace poolhall::scene_checks
