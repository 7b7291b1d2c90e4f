#pragma once

#include <cmath>
#include <cstdint>

namespace poolhall::client {

/// A number from 0 to 1 that belongs to the pair, without a pattern that the eye could find.
inline float speckle(int x, int y) {
    auto h =
        static_cast<std::uint32_t>(x) * 0x8DA6B343U ^ static_cast<std::uint32_t>(y) * 0xD8163841U;
    h = (h ^ (h >> 13U)) * 0x9E3779B1U;
    h ^= h >> 16U;
    return static_cast<float>(h & 0xFFFFU) / 65535;
}

/// Speckles a unit apart, smoothly joined; 0 to 1.
inline float smooth_noise(float x, float y) {
    const float fx = std::floor(x);
    const float fy = std::floor(y);
    const int ix = static_cast<int>(fx);
    const int iy = static_cast<int>(fy);
    const auto ease = [](float t) { return t * t * (3 - 2 * t); };
    const float tx = ease(x - fx);
    const float ty = ease(y - fy);
    const float top = speckle(ix, iy) + tx * (speckle(ix + 1, iy) - speckle(ix, iy));
    const float bottom = speckle(ix, iy + 1) + tx * (speckle(ix + 1, iy + 1) - speckle(ix, iy + 1));
    return top + ty * (bottom - top);
}

}  // namespace poolhall::client
