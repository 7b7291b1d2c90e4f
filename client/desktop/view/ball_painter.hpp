#pragma once

#include "client/desktop/render/image.hpp"
#include "client/desktop/view/ball_spin.hpp"

#include <SDL2/SDL_rect.h>

#include <cstdint>
#include <string_view>

namespace poolhall::client {

enum class BallLook : std::uint8_t {
    kIvory,  ///< cue ball: six small dots show how it rolls
    kEight,  ///< black, its number in white circles on two sides
    kPlain,  ///< any other: red with the white circles
};

/// By the ball's id: "cue", "8", others.
[[nodiscard]] BallLook look_of(std::string_view id);

struct BallPose {
    BallLook look = BallLook::kIvory;
    Orientation orientation;
    float radius = 1;           ///< px
    SDL_FPoint fraction{0, 0};  ///< of a pixel, by which the centre is right of and below the
                                ///< image's middle pixel corner
    bool sunk = false;          ///< greyed

    friend bool operator==(const BallPose& a, const BallPose& b) {
        return a.look == b.look && a.orientation == b.orientation && a.radius == b.radius &&
               a.fraction.x == b.fraction.x && a.fraction.y == b.fraction.y && a.sunk == b.sunk;
    }
};

/// Side of the square image of a ball of this radius; it is even, and the ball's centre is at side
/// / 2 + fraction.
[[nodiscard]] int ball_image_side(float radius);

/// A shaded ball on nothing, its edge anti-aliased for just this place between pixels.
void paint_ball(const BallPose& pose, Image& image);

}  // namespace poolhall::client
