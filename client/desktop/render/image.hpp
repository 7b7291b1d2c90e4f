#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poolhall::client {

/// Pixels in memory, SDL_PIXELFORMAT_ARGB8888, row by row from the top; transparent black at first.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> pixels;

    Image() = default;

    Image(int w, int h)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

    [[nodiscard]] std::uint32_t* row(int y) {
        return pixels.data() + static_cast<std::ptrdiff_t>(y) * width;
    }

    [[nodiscard]] const std::uint32_t* row(int y) const {
        return pixels.data() + static_cast<std::ptrdiff_t>(y) * width;
    }

    [[nodiscard]] int pitch() const { return width * static_cast<int>(sizeof(std::uint32_t)); }
};

}  // namespace poolhall::client
