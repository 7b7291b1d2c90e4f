#pragma once

#include "shared/math/vec2.hpp"

#include <cstddef>
#include <cstdint>

namespace poolhall::lab {

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers on every machine, unlike the standard
/// library's distributions.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15ULL;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31U);
    }

    /// In [low, high).
    double uniform(double low, double high) {
        return low + static_cast<double>(next() >> 11U) * 0x1p-53 * (high - low);
    }

    /// In [0, count).
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

    /// A vector in the unit disc, not zero: a direction without trigonometry.
    Vec2 direction() {
        for (;;) {
            const Vec2 v{uniform(-1, 1), uniform(-1, 1)};
            if (dot(v, v) <= 1 && dot(v, v) > 0) return v;
        }
    }

  private:
    std::uint64_t state_;
};

}  // namespace poolhall::lab
