#include "client/desktop/view/table_view.hpp"

#include "client/desktop/render/colour.hpp"
#include "client/desktop/view/layout.hpp"
#include "client/desktop/view/overlays.hpp"
#include "client/desktop/view/table_painter.hpp"
#include "shared/table/pool_table.hpp"
#include "tests/client/desktop_view/picture.hpp"
#include "tests/client/desktop_view/sample_views.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

bool is_green(SDL_Color c) {
    return c.g > c.r + 30 && c.g > c.b + 15;
}

bool is_wood(SDL_Color c) {
    return c.r > c.g + 20 && c.g >= c.b;
}

int brightness(SDL_Color c) {
    return c.r + c.g + c.b;
}

int difference(SDL_Color a, SDL_Color b) {
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

SDL_FPoint moved(SDL_FPoint p, float x, float y) {
    return {p.x + x, p.y + y};
}

Layout layout_for(const ViewState& state, SDL_Point size) {
    return layout_of(state.table, state.ball_radius, size.x, size.y);
}

// How many pixels around the centre differ between the two pictures.
int differing(const Picture& a, const Picture& b, SDL_FPoint centre, float radius) {
    int count = 0;
    for (float y = -radius; y <= radius; ++y) {
        for (float x = -radius; x <= radius; ++x) {
            if (std::hypot(x, y) <= radius &&
                difference(a.at(moved(centre, x, y)), b.at(moved(centre, x, y))) > 6)
                ++count;
        }
    }
    return count;
}

class AtSize : public testing::TestWithParam<SDL_Point> {
  protected:
    ViewState state = samples::start();
    Layout layout = layout_for(state, GetParam());
    Picture picture{GetParam()};
};

TEST_P(AtSize, ClothWoodAndRoomAreWhereTheyBelong) {
    picture.draw(state);
    EXPECT_TRUE(is_green(picture.at(layout.to_pixels({0, 0.05}))));
    EXPECT_TRUE(is_green(picture.at(layout.to_pixels({0.3, -0.2}))));
    const float wood = kWoodWidth / 2 * layout.ball;
    EXPECT_TRUE(is_wood(picture.at({layout.table.x + wood, layout.centre.y + 2 * layout.ball})));
    EXPECT_TRUE(is_wood(
        picture.at({layout.centre.x + 3 * layout.ball, layout.table.y + layout.table.h - wood})));
    const SDL_Color room = to_colour(kRoom);
    const SDL_FRect& table = layout.table;
    const bool space_above = table.y - layout.top.h > 8 * layout.ball;
    const bool space_beside = table.x > 8 * layout.ball;
    const SDL_FPoint above{layout.centre.x, table.y - 5 * layout.ball};
    const SDL_FPoint beside{table.x - 5 * layout.ball, layout.centre.y};
    EXPECT_TRUE(!space_above || difference(picture.at(above), room) == 0);
    EXPECT_TRUE(!space_beside || difference(picture.at(beside), room) == 0);
}

TEST_P(AtSize, BallsAreWhereTheViewSays) {
    state.aim.reset();
    picture.draw(state);
    const SDL_FPoint cue = layout.to_pixels(state.balls[0].r);
    const float ball = layout.ball;
    EXPECT_GT(brightness(picture.at(moved(cue, -0.2F * ball, -0.2F * ball))), 600);
    EXPECT_TRUE(is_green(picture.at(moved(cue, -1.3F * ball, 0))));
    EXPECT_GT(brightness(picture.at(moved(cue, -0.8F * ball, 0))), 450);
    const SDL_FPoint eight = layout.to_pixels(state.balls[1].r);
    EXPECT_LT(brightness(picture.at(moved(eight, 0.75F * ball, 0))), 150);
    EXPECT_GT(brightness(picture.at(moved(eight, -0.42F * ball, 0))),
              400);  // the circle around its number
}

TEST_P(AtSize, PocketsAreDarkHolesAtTheRails) {
    picture.draw(state);
    for (const double x : {-1.0, 0.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            const Vec2 mouth{x * state.table.length / 2, y * state.table.width / 2};
            EXPECT_LT(brightness(picture.at(layout.to_pixels(mouth))), 60) << x << ' ' << y;
        }
    }
}

TEST_P(AtSize, TheNoseIsTheEdgeOfThePlayfield) {
    picture.draw(state);
    const float x = layout.to_pixels({0.2, 0}).x;
    const auto row = [&](float from_edge) {
        return picture.at({x, layout.cloth.y + layout.cloth.h + from_edge});
    };
    EXPECT_GT(brightness(row(0.14F * layout.ball + 1)), brightness(row(-2)) + 15);
}

TEST_P(AtSize, TheArrowIsBeneathTheBall) {
    Picture without(GetParam());
    picture.draw(state);
    state.aim.reset();
    without.draw(state);
    const SDL_FPoint cue = layout.to_pixels(state.balls[0].r);
    EXPECT_EQ(differing(picture, without, cue, layout.ball - 1.5F), 0);
    const SDL_FPoint on_arrow = moved(cue, (kArrowLength - 0.8F) * layout.ball, 0);
    EXPECT_GT(brightness(picture.at(on_arrow)), 500);
    EXPECT_TRUE(is_green(without.at(on_arrow)));
    EXPECT_TRUE(is_green(picture.at(moved(cue, (kArrowLength + 0.3F) * layout.ball, 0))));
}

TEST_P(AtSize, SunkBallsAreGreyInTheirPocket) {
    state.aim.reset();
    state.balls[0] = {"cue", {0.01, state.table.width / 2 - 0.03}, true};
    picture.draw(state);
    const SDL_Color c = picture.at(layout.to_pixels({0, state.table.width / 2}));
    EXPECT_GT(brightness(c), 150);
    EXPECT_LT(brightness(c), 550);
    EXPECT_LT(std::abs(c.r - c.g) + std::abs(c.g - c.b), 40);
}

TEST_P(AtSize, MarksAreYellowCirclesOfABallsRadius) {
    state.marks.push_back({{0.1, 0.1}});
    picture.draw(state);
    const SDL_FPoint mark = layout.to_pixels({0.1, 0.1});
    int yellow = 0;
    for (int i = 0; i < 32; ++i) {
        const auto angle = static_cast<float>(i) * 0.19635F;
        const SDL_Color c =
            picture.at(moved(mark, layout.ball * std::cos(angle), layout.ball * std::sin(angle)));
        if (c.r > 120 && c.g > 120 && c.b < c.r - 25) ++yellow;
    }
    EXPECT_GT(yellow, 24);
    EXPECT_TRUE(is_green(picture.at(mark)));
}

INSTANTIATE_TEST_SUITE_P(Windows, AtSize,
                         testing::Values(SDL_Point{1280, 720}, SDL_Point{480, 320},
                                         SDL_Point{800, 600}, SDL_Point{600, 1000},
                                         SDL_Point{1400, 420}, SDL_Point{2560, 1440}));

TEST(TableViewTest, PredictedPathsAreWhiteForTheCueBallAndMagentaForTheEight) {
    const ViewState state = samples::aiming();
    const SDL_Point size{1280, 720};
    Picture picture(size);
    picture.draw(state);
    const Layout layout = layout_for(state, size);
    const auto middle = [&](const PathSegment& path) {
        return layout.to_pixels(0.5 * (path.from + path.to));
    };
    const AimPrediction& seen = state.aim->prediction;
    ASSERT_TRUE(seen.object_after && seen.cue_after);
    const SDL_Color eight = picture.at(middle(*seen.object_after));
    EXPECT_GT(eight.r, eight.g + 40);
    EXPECT_GT(eight.b, eight.g + 40);
    const SDL_Color cue = picture.at(middle(*seen.cue_after));
    EXPECT_GT(std::min({cue.r, cue.g, cue.b}), 110);
}

TEST(TableViewTest, TrailRingsFade) {
    ViewState state = samples::start();
    const SDL_Point size{1280, 720};
    const Layout layout = layout_for(state, size);
    state.trail = {{{0, 0.15}, BallIndex{0}, 1.0},
                   {{0, -0.15}, BallIndex{0}, 0.15},
                   {{0.2, 0}, BallIndex{9}, 1.0}};
    Picture picture(size);
    picture.draw(state);
    const auto ring = [&](Vec2 r) {
        return brightness(picture.at(moved(layout.to_pixels(r), layout.ball - 1, 0)));
    };
    EXPECT_GT(ring({0, 0.15}), ring({0, -0.15}) + 100);
}

TEST(TableViewTest, BallsRollVisibly) {
    for (const std::size_t ball : {0U, 1U}) {
        const SDL_Point size{1280, 720};
        ViewState state = samples::start();
        state.aim.reset();
        state.balls[ball].r = {0.1, 0};
        Picture set_down(size);
        set_down.draw(state);
        Picture rolled(size);
        state.balls[ball].r = {0.07, 0.01};
        rolled.draw(state);
        state.balls[ball].r = {0.1, 0};
        rolled.draw(state);
        const Layout layout = layout_for(state, size);
        EXPECT_GT(differing(set_down, rolled, layout.to_pixels({0.1, 0}), layout.ball - 2), 10)
            << ball;
    }
}

TEST(TableViewTest, AModeShowsItsIconAtTheLowerLeft) {
    const SDL_Point size{1280, 720};
    ViewState state = samples::start();
    Picture none(size);
    none.draw(state);
    const Layout layout = layout_for(state, size);
    const SDL_FPoint corner{layout.cloth.x + 4 * layout.ball,
                            layout.table.y + layout.table.h - kWoodWidth / 2 * layout.ball};
    state.step_mode = true;
    Picture step(size);
    step.draw(state);
    state.step_mode = false;
    state.collision_mode = true;
    Picture collision(size);
    collision.draw(state);
    EXPECT_GT(differing(none, step, corner, 1.5F * layout.ball), 200);
    EXPECT_GT(differing(step, collision, corner, 1.5F * layout.ball), 50);
}

TEST(TableViewTest, WonAndLostDifferInShapeNotOnlyInColour) {
    const SDL_Point size{1280, 720};
    ViewState state = samples::start();
    Picture won(size);
    Picture lost(size);
    state.banner = Banner{"The end", "", Tone::kWon};
    won.draw(state);
    state.banner->tone = Tone::kLost;
    lost.draw(state);
    // Where one symbol is dark and the other is not, whatever their colours.
    int shape = 0;
    for (int y = 300; y < 440; ++y) {
        for (int x = 440; x < 560; ++x) {
            const SDL_FPoint p{static_cast<float>(x), static_cast<float>(y)};
            if ((brightness(won.at(p)) < 200) != (brightness(lost.at(p)) < 200)) ++shape;
        }
    }
    EXPECT_GT(shape, 200);
}

TEST(TableViewTest, EveryViewCoversTheWholeOutputWhateverItsSize) {
    constexpr Uint32 kUntouched = 0xFF00FF01;
    for (const SDL_Point size : {SDL_Point{1, 1}, SDL_Point{7, 90}, SDL_Point{90, 7},
                                 SDL_Point{64, 64}, SDL_Point{320, 200}}) {
        Picture picture(size);
        for (const samples::NamedView& view : samples::all()) {
            SDL_FillRect(picture.surface(), nullptr, kUntouched);
            picture.draw(view);
            int untouched = 0;
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    const SDL_Color c = picture.at({static_cast<float>(x), static_cast<float>(y)});
                    untouched += c.r == 255 && c.g == 0 && c.b == 1 ? 1 : 0;
                }
            }
            EXPECT_EQ(untouched, 0) << view.name << ' ' << size.x << " x " << size.y;
        }
    }
}

/// A table of each kind at rest.
ViewState bare(const Table& table) {
    ViewState state = samples::start();
    state.aim.reset();
    state.placement.reset();
    state.balls.clear();
    state.table = table;
    return state;
}

TEST_P(AtSize, PoolTableHasItsHolesAndMouthsWhereTheyAreInThePhysics) {
    state = bare({2.54, 1.27, true, PocketModel::kPool});
    layout = layout_for(state, GetParam());
    picture.draw(state);
    const PoolTable pool(state.table);
    for (const Hole& hole : pool.holes())
        EXPECT_LT(brightness(picture.at(layout.to_pixels(hole.centre))), 60) << name(hole.pocket);
    for (const CushionLine& nose : pool.lines().first(6)) {
        // Rubber behind the nose, cloth before it: both are green.
        const Vec2 middle = 0.5 * (nose.from + nose.to);
        EXPECT_TRUE(is_green(picture.at(layout.to_pixels(middle + 0.02 * nose.normal))));
        EXPECT_TRUE(is_green(picture.at(layout.to_pixels(middle - 0.02 * nose.normal))));
    }
    state.balls = {{"8", pool.holes()[0].centre + Vec2{0.04, -0.03}, true}};
    picture.draw(state);
    EXPECT_GT(brightness(picture.at(layout.to_pixels(pool.holes()[0].centre))), 80)
        << "a sunk ball lies in the hole";
}

TEST_P(AtSize, CirclesAreHolesUnderUnbrokenRails) {
    const Vec2 edge{0.5, -0.5};
    state = bare({2, 1, true, PocketModel::kCircles, {{"m", {0, 0}, 0.05}, {"e", edge, 0.08}}});
    layout = layout_for(state, GetParam());
    picture.draw(state);
    EXPECT_LT(brightness(picture.at(layout.to_pixels({0, 0}))), 60);
    EXPECT_TRUE(is_green(picture.at(layout.to_pixels({0.075, 0}))));
    EXPECT_LT(brightness(picture.at(layout.to_pixels(edge + Vec2{0, 0.02}))), 60);
    EXPECT_TRUE(is_green(picture.at(layout.to_pixels(edge - Vec2{0, 0.035})))) << "rubber";
}

TEST(TableViewTest, ATableWithoutRailsOrPocketsIsAllCloth) {
    ViewState state = samples::start();
    state.table.rails = false;
    state.table.pockets = PocketModel::kNone;
    const SDL_Point size{800, 600};
    Picture picture(size);
    picture.draw(state);
    const Layout layout = layout_for(state, size);
    EXPECT_TRUE(is_green(picture.at(layout.to_pixels({state.table.length / 2, 0.1}))));
    EXPECT_TRUE(
        is_green(picture.at(layout.to_pixels({state.table.length / 2, state.table.width / 2}))));
}

TEST(TableViewTest, ALostDeviceIsDrawnAnew) {
    const SDL_Point size{800, 500};
    const ViewState state = samples::aiming();
    Picture steady(size);
    Picture lost(size);
    steady.draw(state);
    lost.draw(state);
    lost.reset();
    lost.draw(state);
    EXPECT_EQ(differing(steady, lost, {400, 250}, 400), 0);
}

// A real window of SDL's dummy video driver.
class InWindow : public testing::Test {
  protected:
    void SetUp() override {
        SDL_setenv("SDL_VIDEODRIVER", "dummy", 1);
        ASSERT_EQ(SDL_Init(SDL_INIT_VIDEO), 0) << SDL_GetError();
        window = SDL_CreateWindow("test", 0, 0, 1280, 720, SDL_WINDOW_RESIZABLE);
        renderer = SDL_CreateRenderer(window, -1, SDL_RENDERER_SOFTWARE);
        ASSERT_NE(renderer, nullptr) << SDL_GetError();
    }

    void TearDown() override {
        SDL_DestroyRenderer(renderer);
        SDL_DestroyWindow(window);
        SDL_Quit();
    }

    SDL_Color read(SDL_FPoint p) {
        const SDL_Rect rect{static_cast<int>(p.x), static_cast<int>(p.y), 1, 1};
        Uint32 pixel = 0;
        EXPECT_EQ(SDL_RenderReadPixels(renderer, &rect, SDL_PIXELFORMAT_ARGB8888, &pixel, 4), 0)
            << SDL_GetError();
        return {static_cast<Uint8>(pixel >> 16U), static_cast<Uint8>(pixel >> 8U),
                static_cast<Uint8>(pixel), 255};
    }

    SDL_Window* window = nullptr;
    SDL_Renderer* renderer = nullptr;
};

TEST_F(InWindow, ThePictureFollowsTheWindowsSize) {
    DrawingSurface surface(renderer);
    TableView view;
    const ViewState state = samples::start();
    double now_s = 0;
    for (const SDL_Point size :
         {SDL_Point{1280, 720}, SDL_Point{700, 800}, SDL_Point{1500, 500}, SDL_Point{480, 320}}) {
        SDL_SetWindowSize(window, size.x, size.y);
        SDL_PumpEvents();
        for (int frame = 0; frame < 3;
             ++frame, now_s += 0.1) {  // while the size settles, and after
            surface.canvas.begin(to_colour(kRoom));
            view.draw(surface, state, now_s);
            surface.canvas.finish();
            EXPECT_TRUE(is_green(read(view.to_pixels({0, 0.1})))) << size.x;
            EXPECT_GT(brightness(read(view.to_pixels(state.balls[0].r + Vec2{-0.01, 0.01}))), 500)
                << size.x;
            EXPECT_LT(brightness(read(view.to_pixels({0, state.table.width / 2}))), 90) << size.x;
        }
        const Vec2 there = view.to_table(view.to_pixels({0.4, -0.2}));
        EXPECT_NEAR(there.x, 0.4, 1e-6);
        EXPECT_NEAR(there.y, -0.2, 1e-6);
    }
}

}  // namespace
}  // namespace poolhall::client
