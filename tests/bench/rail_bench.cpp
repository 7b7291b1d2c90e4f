// What an impact on a rail costs, by model.

#include "shared/physics/contact/han_rail.hpp"
#include "shared/physics/contact/mathavan_rail.hpp"
#include "tests/shared/random.hpp"

#include <benchmark/benchmark.h>
#include <cmath>
#include <vector>

namespace poolhall {
namespace {

struct Ball {
    Vec3 v;
    Vec3 w;
};

/// Rolling balls with side spin at all angles, up to 3 m/s.
std::vector<Ball> rolling_balls(double radius) {
    testing::Random random(5);
    std::vector<Ball> balls;
    for (int i = 0; i < 256; ++i) {
        const Vec2 direction = random.direction();
        const Vec2 v{3 * direction.x, 3 * std::abs(direction.y)};
        balls.push_back({{v.x, v.y, 0}, {-v.y / radius, v.x / radius, random.uniform(-80, 80)}});
    }
    return balls;
}

/// 256 impacts on a pool table's rail.
void rail_impact(benchmark::State& state, void (*bounce)(const RailContact&, Vec3&, Vec3&)) {
    constexpr RailContact kRail{{0, 1}, 0.028575, 0.170097, 0.036576, 0.85, 0.2, 0.2};
    const std::vector<Ball> balls = rolling_balls(kRail.radius);
    for (Ball ball : balls) {
        const double v_n = ball.v.y;
        bounce(kRail, ball.v, ball.w);
        if (ball.v.y > -0.5 * v_n || ball.v.y < -v_n) {
            state.SkipWithError("a ball does not bounce as it should");
            return;
        }
    }
    for ([[maybe_unused]] auto _ : state) {
        for (Ball ball : balls) {
            bounce(kRail, ball.v, ball.w);
            benchmark::DoNotOptimize(ball);
        }
    }
    state.counters["per_impact"] = benchmark::Counter(
        static_cast<double>(balls.size()),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(rail_impact, han2005, &bounce_han2005);
BENCHMARK_CAPTURE(rail_impact, mathavan2010_fast, &bounce_mathavan2010_fast);
BENCHMARK_CAPTURE(rail_impact, mathavan2010,
                  static_cast<void (*)(const RailContact&, Vec3&, Vec3&)>(&bounce_mathavan2010));

}  // namespace
}  // namespace poolhall
