#include "client/desktop/view/solver_paths.hpp"

#include "tests/client/desktop_view/picture.hpp"
#include "tests/client/desktop_view/sample_views.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

constexpr SDL_Point kSize{1280, 720};

Layout layout_for(const ViewState& state) {
    return layout_of(state.table, state.ball_radius, kSize.x, kSize.y);
}

bool is_near(SDL_Color a, SDL_Color b) {
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) < 60;
}

bool overlap(const SDL_FRect& box, SDL_FPoint p) {
    return p.x >= box.x && p.x <= box.x + box.w && p.y >= box.y && p.y <= box.y + box.h;
}

/// One solver whose only ball goes straight from one place to another.
SolverView straight(Vec2 from, Vec2 to) {
    SolverView view;
    view.name = "event";
    view.paths = {{from, to}};
    view.balls = {to};
    return view;
}

TEST(SolverPaths, EachSolverHasItsOwnColourOnTheCloth) {
    ViewState state = samples::start();
    state.aim.reset();
    for (int i = 0; i < 3; ++i) {
        const double y = -0.2 + 0.1 * i;
        state.solvers.push_back(straight({-0.2, y}, {0.2, y}));
    }
    Picture picture({2560, 1440});
    picture.draw(state);
    const Layout layout = layout_of(state.table, state.ball_radius, 2560, 1440);
    for (std::size_t i = 0; i < 3; ++i) {
        const SDL_Color colour = solver_colour(i);
        EXPECT_TRUE(
            is_near(picture.at(layout.to_pixels({0, state.solvers[i].paths[0][0].y})), colour));
        // A thin ring fades into its neighbours: what counts is that something is there.
        const SDL_FPoint end = layout.to_pixels(state.solvers[i].balls[0]);
        const SDL_FPoint inside{end.x, end.y - 0.6F * layout.ball};
        EXPECT_FALSE(is_near(picture.at({end.x, end.y - layout.ball}), picture.at(inside)));
    }
}

TEST(SolverPaths, EqualWaysShowAsStripes) {
    ViewState state = samples::start();
    state.aim.reset();
    for (int i = 0; i < 3; ++i)
        state.solvers.push_back(straight({-0.2, -0.2}, {0.2, -0.2}));
    Picture picture({2560, 1440});
    picture.draw(state);
    const Layout layout = layout_of(state.table, state.ball_radius, 2560, 1440);
    const SDL_FPoint middle = layout.to_pixels({0, -0.2});
    std::array<bool, 3> seen{};
    for (float y = -12; y <= 12; ++y) {
        for (std::size_t i = 0; i < 3; ++i)
            seen[i] = seen[i] || is_near(picture.at({middle.x, middle.y + y}), solver_colour(i));
    }
    EXPECT_EQ(seen, (std::array{true, true, true}));
}

TEST(SolverPaths, TheLegendKeepsOutOfTheWay) {
    const ViewState state = samples::start();
    const Layout layout = layout_for(state);
    const double x = state.table.length / 2;
    const double y = state.table.width / 2;
    for (const Vec2 free : {Vec2{x, y}, Vec2{-x, y}, Vec2{x, -y}, Vec2{-x, -y}}) {
        std::vector<SolverView> solvers;
        for (const Vec2 corner : {Vec2{x, y}, Vec2{-x, y}, Vec2{x, -y}, Vec2{-x, -y}}) {
            if (corner != free) solvers.push_back(straight(corner, {0, 0.9 * corner.y}));
        }
        const SDL_FRect box = legend_box(layout, solvers, {300, 80});
        const Vec2 middle = layout.to_table({box.x + box.w / 2, box.y + box.h / 2});
        EXPECT_GT(middle.x * free.x, 0) << free.x << ' ' << free.y;
        EXPECT_GT(middle.y * free.y, 0) << free.x << ' ' << free.y;
    }
}

TEST(SolverPaths, TheLegendRatherHidesPathsThanABall) {
    const ViewState state = samples::start();
    const Layout layout = layout_for(state);
    std::vector<SolverView> solvers;
    for (const double x : {-0.6, 0.6}) {
        for (const double y : {-0.3, 0.3}) {
            for (int i = 0; i < 5; ++i)
                solvers.push_back(straight({x, y}, {0, y}));
        }
    }
    solvers.push_back(straight({-0.7, 0.3}, {-0.6, 0.3}));
    const SDL_FRect box = legend_box(layout, solvers, {300, 80});
    for (const SolverView& solver : solvers)
        EXPECT_FALSE(overlap(box, layout.to_pixels(solver.balls[0])));
}

TEST(SolverPaths, TheLegendIsDrawnAtEverySize) {
    for (const SDL_Point size : {SDL_Point{480, 320}, kSize, SDL_Point{3840, 2160}}) {
        ViewState state = samples::start();
        state.aim.reset();
        Picture without(size);
        without.draw(state);
        state.solvers = {straight({0.3, -0.3}, {0.5, -0.3})};
        Picture with(size);
        with.draw(state);
        const Layout layout = layout_of(state.table, state.ball_radius, size.x, size.y);
        const SDL_FPoint corner{layout.cloth.x + 3 * layout.ball,
                                layout.cloth.y + 1.2F * layout.ball};
        EXPECT_FALSE(is_near(with.at(corner), without.at(corner))) << size.x;
    }
}

}  // namespace
}  // namespace poolhall::client
