#pragma once

#include "shared/math/vec3.hpp"

#include <bit>
#include <cstdint>

namespace poolhall {

/// The 64-bit fingerprint of a shot: equal on every compiler, optimisation level and processor.
///
/// A word w enters as h = (h xor w) * 0x9E3779B97F4A7C15, then h = h xor (h >> 32); h starts as
/// 0xCBF29CE484222325. It detects divergence; it is no defence against forgery.
class StateHash {
  public:
    constexpr void add(std::uint64_t word) {
        value_ = (value_ ^ word) * 0x9E3779B97F4A7C15ULL;
        value_ ^= value_ >> 32U;
    }

    /// The bits as a double, with -0 taken as 0: the two compare equal, so they must hash equal.
    constexpr void add(Real number) {
        const auto rounded = static_cast<double>(number);
        add(std::bit_cast<std::uint64_t>(rounded == 0 ? 0.0 : rounded));
    }

    constexpr void add(const Vec3& vector) {
        add(vector.x);
        add(vector.y);
        add(vector.z);
    }

    [[nodiscard]] constexpr std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xCBF29CE484222325ULL;
};

}  // namespace poolhall
