#include "client/desktop/render/rasterizer.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace poolhall::client {
namespace {

constexpr SDL_Color kHalf{255, 0, 0, 128};
constexpr SDL_Color kOpaque{255, 255, 255, 255};

unsigned alpha(const Rasterizer& raster, int x, int y) {
    return raster.layer().row(y)[x] >> 24U;
}

double total_alpha(const Rasterizer& raster) {
    double sum = 0;
    for (const std::uint32_t pixel : raster.layer().pixels)
        sum += static_cast<double>(pixel >> 24U) / 255;
    return sum;
}

TEST(RasterizerTest, PixelsOnSharedEdgesAreDrawnOnce) {
    Rasterizer raster;
    raster.resize(64, 64);
    Mesh mesh;
    add_rounded_rect(mesh, {8, 8, 48, 48}, 4, kHalf);
    raster.draw(mesh);
    for (int y = 14; y < 50; ++y) {
        for (int x = 14; x < 50; ++x)
            ASSERT_EQ(alpha(raster, x, y), 128U) << x << ' ' << y;
    }
}

TEST(RasterizerTest, DiscsCoverTheirAreaWhereverTheirCentreFallsBetweenPixels) {
    Rasterizer raster;
    raster.resize(64, 64);
    for (int i = 0; i < 20; ++i) {
        const float shift = 0.05F * static_cast<float>(i);
        Mesh mesh;
        add_disc(mesh, {30 + shift, 30.5F + 0.37F * shift}, 9.25F, kOpaque);
        raster.draw(mesh);
        const double area = std::numbers::pi * 9.25 * 9.25;
        EXPECT_NEAR(total_alpha(raster), area, 0.01 * area) << shift;
        raster.clear();
    }
}

TEST(RasterizerTest, ShapesOutsideTheLayerAreClipped) {
    Rasterizer raster;
    raster.resize(16, 16);
    Mesh mesh;
    add_disc(mesh, {-50, 8}, 20, kOpaque);
    add_disc(mesh, {8, 1e9F}, 20, kOpaque);
    add_line(mesh, {-1e6F, 8}, {1e6F, 8}, {1, kOpaque});
    const float infinity = std::numeric_limits<float>::infinity();
    add_disc(mesh, {infinity, NAN}, 5, kOpaque);
    raster.draw(mesh);
    EXPECT_GT(alpha(raster, 8, 8), 0U);
    EXPECT_EQ(alpha(raster, 8, 0), 0U);
}

TEST(RasterizerTest, DirtyBandsHoldAllThatWasDrawnAndClearEmptiesThem) {
    Rasterizer raster;
    raster.resize(100, 100);
    Mesh mesh;
    add_disc(mesh, {20, 20}, 6, kOpaque);
    add_disc(mesh, {80, 90}, 4, kOpaque);
    raster.draw(mesh);
    const auto bands = raster.dirty_bands();
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 100; ++x) {
            const SDL_Point pixel{x, y};
            bool inside = false;
            for (const SDL_Rect& band : bands)
                inside = inside || SDL_PointInRect(&pixel, &band) == SDL_TRUE;
            ASSERT_TRUE(inside || alpha(raster, x, y) == 0) << x << ' ' << y;
        }
    }
    raster.clear();
    EXPECT_EQ(total_alpha(raster), 0);
    EXPECT_TRUE(raster.dirty_bands().empty());
}

}  // namespace
}  // namespace poolhall::client
