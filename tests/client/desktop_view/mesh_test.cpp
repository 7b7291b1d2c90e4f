#include "client/desktop/render/mesh.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace poolhall::client {
namespace {

constexpr SDL_Color kOpaque{255, 255, 255, 255};
constexpr double kPi = std::numbers::pi;

// What the alpha of the mesh adds up to: exact, as alpha is linear within a triangle.
double volume(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) {
            return mesh.vertices[static_cast<std::size_t>(mesh.indices[i + k])];
        };
        const SDL_Vertex a = at(0);
        const SDL_Vertex b = at(1);
        const SDL_Vertex c = at(2);
        const double area =
            std::abs((b.position.x - a.position.x) * (c.position.y - a.position.y) -
                     (b.position.y - a.position.y) * (c.position.x - a.position.x)) /
            2;
        sum += area * (a.color.a + b.color.a + c.color.a) / 3 / 255;
    }
    return sum;
}

class DiscOfRadius : public testing::TestWithParam<float> {};

TEST_P(DiscOfRadius, CoversItsArea) {
    Mesh mesh;
    add_disc(mesh, {50.3F, 20.7F}, GetParam(), kOpaque);
    const double area = kPi * GetParam() * GetParam();
    EXPECT_NEAR(volume(mesh), area, 0.04 * area + 0.3);
}

INSTANTIATE_TEST_SUITE_P(FromPixelToTable, DiscOfRadius,
                         testing::Values(0.2F, 0.5F, 1.0F, 3.3F, 17.4F, 200.0F));

TEST(RingTest, CoversCircumferenceTimesWidthAlsoWhenThinnerThanAPixel) {
    for (const float width : {0.3F, 1.0F, 2.5F, 8.0F}) {
        Mesh mesh;
        add_ring(mesh, {100, 100}, 30, {width, kOpaque});
        EXPECT_NEAR(volume(mesh), 2 * kPi * 30 * width, 0.02 * 2 * kPi * 30 * width) << width;
    }
}

TEST(LineTest, CoversLengthTimesWidthInAnyDirection) {
    for (int i = 0; i < 12; ++i) {
        const double angle = 0.55 * i;
        Mesh mesh;
        const SDL_FPoint to{static_cast<float>(10 + 40 * std::cos(angle)),
                            static_cast<float>(10 + 40 * std::sin(angle))};
        add_line(mesh, {10, 10}, to, {3, kOpaque});
        EXPECT_NEAR(volume(mesh), 120, 1.5) << angle;
    }
}

TEST(DashedLineTest, CoversHalfOfItsLength) {
    Mesh mesh;
    add_dashed_line(mesh, {0, 0}, {200, 0}, 10, {2, kOpaque});
    EXPECT_NEAR(volume(mesh), 200, 5);
}

TEST(ConvexTest, CoversAPolygonsArea) {
    Mesh mesh;
    const std::array<SDL_FPoint, 3> triangle{{{0, 0}, {30, 0}, {0, 40}}};
    add_convex(mesh, triangle, kOpaque);
    EXPECT_NEAR(volume(mesh), 600, 6);
}

// Four points: a square of side 10 with a triangle 20 high on each side. One fan, so that no part
// is drawn twice.
TEST(StarShapeTest, CoversAPolygonsAreaOnce) {
    Mesh mesh;
    const std::array<SDL_FPoint, 8> star{
        {{0, -25}, {5, -5}, {25, 0}, {5, 5}, {0, 25}, {-5, 5}, {-25, 0}, {-5, -5}}};
    add_star_shape(mesh, {0, 0}, star, kOpaque);
    EXPECT_NEAR(volume(mesh), 500, 5);
}

TEST(RoundedRectTest, CoversTheRectangleLessItsCorners) {
    Mesh mesh;
    add_rounded_rect(mesh, {10, 10, 60, 40}, 8, kOpaque);
    EXPECT_NEAR(volume(mesh), 2400 - (4 - kPi) * 64, 12);
}

TEST(MeshTest, WhatHasNoExtentAddsNothing) {
    Mesh mesh;
    add_disc(mesh, {1, 1}, 0, kOpaque);
    add_ring(mesh, {1, 1}, 0, {1, kOpaque});
    add_line(mesh, {1, 1}, {1, 1}, {1, kOpaque});
    add_line(mesh, {1, 1}, {NAN, 1}, {1, kOpaque});
    add_dashed_line(mesh, {1, 1}, {9, 1}, 0, {1, kOpaque});
    add_rounded_rect(mesh, {1, 1, 0, 5}, 1, kOpaque);
    add_glow(mesh, {1, 1}, {0, 1}, kOpaque);
    EXPECT_TRUE(mesh.empty());
}

}  // namespace
}  // namespace poolhall::client
