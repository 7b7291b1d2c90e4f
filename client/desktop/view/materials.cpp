#include "client/desktop/view/materials.hpp"

#include "client/desktop/render/noise.hpp"

#include <cmath>

namespace poolhall::client {
namespace {

constexpr Rgb kCloth{0.060F, 0.455F, 0.285F};
constexpr Rgb kDarkWood{0.200F, 0.082F, 0.040F};
constexpr Rgb kLightWood{0.500F, 0.245F, 0.115F};

}  // namespace

Rgb cloth(int pixel_x, int pixel_y, float light) {
    // Threads a few pixels long in both directions, and patches where the nap lies differently.
    const float warp = speckle(pixel_x / 3, pixel_y) - 0.5F;
    const float weft = speckle(pixel_x, pixel_y / 3 + 4096) - 0.5F;
    const float nap =
        smooth_noise(static_cast<float>(pixel_x) / 43, static_cast<float>(pixel_y) / 37) - 0.5F;
    return light * (1 + 0.035F * warp + 0.035F * weft + 0.035F * nap) * kCloth;
}

Rgb wood(float along, float across) {
    const float bend = smooth_noise(0.11F * along, 0.5F * across);
    const float rings = 0.5F + 0.5F * std::sin(7.0F * across + 9.0F * bend + 0.25F * along);
    const float streaks = smooth_noise(0.45F * along, 9.0F * across);
    const float fibres = smooth_noise(2.2F * along, 34.0F * across);
    const float tone =
        0.10F + 0.42F * rings * (0.5F + 0.5F * streaks) + 0.28F * streaks + 0.16F * fibres;
    return mix(kDarkWood, kLightWood, saturate(tone));
}

}  // namespace poolhall::client
