#pragma once

#include <SDL2/SDL_pixels.h>

#include <algorithm>
#include <cstdint>

namespace poolhall::client {

/// Red, green and blue as the display takes them (not linear light), 0 to 1; may go beyond until it
/// is stored.
struct Rgb {
    float r = 0;
    float g = 0;
    float b = 0;
};

constexpr Rgb operator+(Rgb a, Rgb b) {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}

constexpr Rgb operator*(float s, Rgb a) {
    return {s * a.r, s * a.g, s * a.b};
}

/// `a` at t = 0, `b` at t = 1.
constexpr Rgb mix(Rgb a, Rgb b, float t) {
    return (1 - t) * a + t * b;
}

constexpr float mix(float a, float b, float t) {
    return (1 - t) * a + t * b;
}

constexpr float saturate(float value) {
    return std::clamp(value, 0.0F, 1.0F);
}

/// 0 up to `low`, 1 from `high`, smooth between them.
constexpr float smooth_step(float low, float high, float value) {
    const float t = saturate((value - low) / (high - low));
    return t * t * (3 - 2 * t);
}

/// Rounded: nothing here is negative, and std::lround is no constant expression.
constexpr std::uint8_t to_byte(float value) {
    const float and_a_half = saturate(value) * 255 + 0.5F;
    return static_cast<std::uint8_t>(and_a_half);
}

/// A pixel of SDL_PIXELFORMAT_ARGB8888, its colours not multiplied by alpha.
constexpr std::uint32_t to_argb(Rgb colour, float alpha = 1) {
    const std::uint32_t a = to_byte(alpha);
    const std::uint32_t r = to_byte(colour.r);
    const std::uint32_t g = to_byte(colour.g);
    const std::uint32_t b = to_byte(colour.b);
    return a << 24U | r << 16U | g << 8U | b;
}

constexpr SDL_Color to_colour(Rgb colour, float alpha = 1) {
    return {to_byte(colour.r), to_byte(colour.g), to_byte(colour.b), to_byte(alpha)};
}

/// The colour with its alpha multiplied.
constexpr SDL_Color faded(SDL_Color colour, float alpha) {
    colour.a = to_byte(static_cast<float>(colour.a) / 255 * alpha);
    return colour;
}

}  // namespace poolhall::client
