#include "client/desktop/view/layout.hpp"

#include "shared/game/end_game.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

const Table kTable{end_game::kLength, end_game::kWidth, true, PocketModel::kEndGame};
constexpr double kRadius = 0.028575;
constexpr SDL_Point kSizes[] = {{1280, 720},  {480, 320},  {640, 480},  {1920, 1080},
                                {3840, 2160}, {600, 1000}, {1400, 420}, {2000, 300}};

TEST(LayoutTest, PointsComeBackFromPixels) {
    for (const SDL_Point size : kSizes) {
        const Layout layout = layout_of(kTable, kRadius, size.x, size.y);
        for (const Vec2 point :
             {Vec2{0, 0}, Vec2{0.7, 0.3}, Vec2{-0.775, -0.36}, Vec2{end_game::kBaseLineX, 0.1}}) {
            const Vec2 back = layout.to_table(layout.to_pixels(point));
            EXPECT_NEAR(back.x, point.x, 1e-6) << size.x << 'x' << size.y;
            EXPECT_NEAR(back.y, point.y, 1e-6) << size.x << 'x' << size.y;
        }
    }
}

TEST(LayoutTest, TheTableKeepsItsProportionsAndFitsBetweenTheBars) {
    for (const SDL_Point size : kSizes) {
        const Layout layout = layout_of(kTable, kRadius, size.x, size.y);
        EXPECT_NEAR(layout.cloth.w / layout.cloth.h, kTable.length / kTable.width, 1e-4);
        EXPECT_GE(layout.table.x, 0);
        EXPECT_LE(layout.table.x + layout.table.w, static_cast<float>(size.x));
        EXPECT_GE(layout.table.y, layout.top.h - 0.01F);
        EXPECT_LE(layout.table.y + layout.table.h, layout.bottom.y + 0.01F);
    }
}

TEST(LayoutTest, RightOnTheTableIsRightOnTheScreenAndUpIsUp) {
    const Layout layout = layout_of(kTable, kRadius, 1280, 720);
    const SDL_FPoint corner = layout.to_pixels({kTable.length / 2, kTable.width / 2});
    EXPECT_NEAR(corner.x, layout.cloth.x + layout.cloth.w, 0.01);
    EXPECT_NEAR(corner.y, layout.cloth.y, 0.01);
}

TEST(LayoutTest, AnOutputTooSmallForATableStillHasAScale) {
    for (const SDL_Point size : {SDL_Point{1, 1}, SDL_Point{64, 3}, SDL_Point{3, 64}}) {
        const Layout layout = layout_of(kTable, kRadius, size.x, size.y);
        EXPECT_GT(layout.scale, 0);
        EXPECT_GT(layout.ball, 0);
    }
}

}  // namespace
}  // namespace poolhall::client
