#include "client/desktop/view/ball_painter.hpp"

#include "client/desktop/render/colour.hpp"

#include <array>
#include <cmath>

namespace poolhall::client {
namespace {

constexpr Rgb kIvory{0.97F, 0.94F, 0.85F};
constexpr Rgb kDot{0.78F, 0.12F, 0.13F};
constexpr Rgb kBlack{0.055F, 0.055F, 0.065F};
constexpr Rgb kRed{0.70F, 0.10F, 0.10F};
constexpr Rgb kWhite{0.96F, 0.95F, 0.92F};
constexpr Rgb kInk{0.05F, 0.05F, 0.06F};
constexpr Rgb kClothGlow{0.10F, 0.42F, 0.26F};

struct Normal {
    float x;
    float y;
    float z;
};

constexpr Normal kToLight{-0.445F, 0.545F, 0.710F};     // unit; from above and the upper left
constexpr Normal kHalfWay{-0.2407F, 0.2948F, 0.9247F};  // between it and the eye

float dot(const Normal& a, const Normal& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Part of a pixel `distance` outside an edge that is covered; `pixel` is a pixel's size.
float cover(float distance, float pixel) {
    return saturate(0.5F - distance / pixel);
}

float eight(float x, float y, float pixel) {
    const auto ring = [&](float centre, float radius) {
        constexpr float kHalfStroke = 0.055F;
        return cover(std::abs(std::hypot(x, y - centre) - radius) - kHalfStroke, pixel);
    };
    return std::max(ring(0.165F, 0.13F), ring(-0.145F, 0.17F));
}

// Around the poles of the ball's own z axis.
Rgb numbered(Rgb body, const Vec3& n, bool digit, float pixel) {
    constexpr float kCircle = 0.53F;
    const auto x = static_cast<float>(n.z < 0 ? -n.x : n.x);
    const auto y = static_cast<float>(n.y);
    const float circle = cover(std::hypot(x, y) - kCircle, pixel);
    if (circle == 0) return body;
    const Rgb face = digit ? mix(kWhite, kInk, eight(x, y, pixel)) : kWhite;
    return mix(body, face, circle);
}

// Where three axes at right angles leave the ball. They are askew, so that a ball set down shows
// its dots.
Rgb dotted(const Vec3& n, float pixel) {
    constexpr float kDotRadius = 0.11F;
    constexpr std::array<Vec3, 3> kAxes{{{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}}};
    float nearest = 1;
    for (const Vec3& axis : kAxes) {
        const double along = n.x * axis.x + n.y * axis.y + n.z * axis.z;
        nearest =
            std::min(nearest, static_cast<float>(std::sqrt(std::max(0.0, 1 - along * along))));
    }
    return mix(kIvory, kDot, cover(nearest - kDotRadius, pixel));
}

Rgb surface(const BallPose& pose, const Normal& world) {
    const Vec3 n = to_ball(pose.orientation, {world.x, world.y, world.z});
    const float pixel = 1 / pose.radius;
    switch (pose.look) {
        case BallLook::kIvory:
            return dotted(n, pixel);
        case BallLook::kEight:
            return numbered(kBlack, n, true, pixel);
        case BallLook::kPlain:
            return numbered(kRed, n, false, pixel);
    }
    return kWhite;
}

// Blinn and Phong's highlight, a wrapped diffuse term, and the cloth's light from below at the rim.
Rgb lit(Rgb colour, const Normal& n) {
    const float facing = dot(n, kToLight);
    const float diffuse = saturate(0.22F + 0.78F * facing);
    const float rim = 1 - n.z;
    const float half = saturate(dot(n, kHalfWay));
    const float highlight = 0.80F * std::pow(half, 90.0F) + 0.16F * std::pow(half, 12.0F);
    const float glow = 0.55F * rim * rim * saturate(0.6F - facing);
    return (0.30F + 0.78F * diffuse) * colour + glow * kClothGlow +
           highlight * Rgb{1, 0.99F, 0.95F};
}

Rgb greyed(Rgb colour) {
    const float grey = 0.30F * colour.r + 0.59F * colour.g + 0.11F * colour.b;
    return 0.55F * mix(colour, {grey, grey, grey}, 0.8F) + 0.06F * Rgb{1, 1, 1};
}

}  // namespace

BallLook look_of(std::string_view id) {
    if (id == "cue") return BallLook::kIvory;
    return id == "8" ? BallLook::kEight : BallLook::kPlain;
}

int ball_image_side(float radius) {
    return 2 * (static_cast<int>(std::ceil(radius)) + 2);
}

void paint_ball(const BallPose& pose, Image& image) {
    const int side = ball_image_side(pose.radius);
    if (image.width != side || image.height != side) image = Image(side, side);
    const float middle = static_cast<float>(side) / 2;
    for (int row = 0; row < side; ++row) {
        std::uint32_t* pixels = image.row(row);
        const float y = (middle + pose.fraction.y - static_cast<float>(row) - 0.5F) / pose.radius;
        for (int column = 0; column < side; ++column) {
            const float x =
                (static_cast<float>(column) + 0.5F - middle - pose.fraction.x) / pose.radius;
            const float distance = std::hypot(x, y);
            const float alpha = cover(distance - 1, 1 / pose.radius);
            pixels[column] = 0;
            if (alpha == 0) continue;
            const float inside = std::min(distance, 0.999F);
            const float pull = distance > inside ? inside / distance : 1;
            const Normal n{pull * x, pull * y, std::sqrt(1 - inside * inside)};
            const Rgb colour = lit(surface(pose, n), n);
            pixels[column] = to_argb(pose.sunk ? greyed(colour) : colour, alpha);
        }
    }
}

}  // namespace poolhall::client
