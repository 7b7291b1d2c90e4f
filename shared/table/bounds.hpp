#pragma once

#include "shared/fields.hpp"

#include <cstddef>

// Bounds of what a scene may hold: wide enough for any experiment that makes sense, narrow enough
// that squares stay finite.
namespace poolhall {

inline constexpr double kMaxLength = 1e6;  ///< m; also kg, m/s^2 and s where nothing else bounds
inline constexpr double kMaxSpeed = 1e6;   ///< m/s
inline constexpr double kMaxSpin = 1e9;    ///< rad/s
inline constexpr std::size_t kMaxIdBytes = 64;

inline constexpr fields::Bounds kIdBytes{1, kMaxIdBytes};
inline constexpr fields::Bounds kPlaces{-kMaxLength, kMaxLength};  ///< m
inline constexpr fields::Bounds kSpeeds{0, kMaxSpeed};             ///< m/s
inline constexpr fields::Bounds kFrictions{0, 10};                 ///< coefficients of friction
inline constexpr fields::Bounds kShares{0, 1};                     ///< coefficients of restitution

}  // namespace poolhall
