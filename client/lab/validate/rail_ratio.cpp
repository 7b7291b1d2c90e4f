#include "client/lab/validate/rail_ratio.hpp"

#include "client/lab/validate/cases.hpp"
#include "shared/physics/simulate.hpp"

namespace poolhall::lab {

namespace {

constexpr double kHz = 50;
constexpr int kSamples = 5;
constexpr double kHeatedCloth = 0.0043;  ///< rolling resistance, read off the recordings

/// Slope of the straight line through `kSamples` samples of x from sample `first` on, m/s.
double slope(const ShotTrace& trace, std::size_t first) {
    constexpr double kMiddle = (kSamples - 1) / 2.0;
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < kSamples; ++i) {
        sum += (i - kMiddle) * trace.sample(first + static_cast<std::size_t>(i), 0).x;
        squares += (i - kMiddle) * (i - kMiddle);
    }
    return sum / squares * kHz;
}

}  // namespace

double rail_ratio(const RailSpec& rail, double speed) {
    Scene scene;
    scene.table = {.length = 2.84, .width = 1.42};
    scene.ball = kCaromBall;
    scene.effects.sliding = SlidingSpec{};
    scene.effects.rolling = RollingSpec{kHeatedCloth};
    scene.effects.rail = rail;
    scene.solver.kind = SolverKind::kEvent;
    // The impact comes in the middle between the samples before and those after.
    const double way = speed * (kSamples - 0.5) / kHz;
    const double edge = inset(scene.table, kCaromBall.radius).x;
    scene.balls = {{"cue", {{edge - way, 0, 0}, {speed, 0, 0}, {0, speed / kCaromBall.radius, 0}}}};
    scene.limits.time = 1;
    const ShotTrace trace = simulate(scene, kHz);
    return -slope(trace, kSamples) / slope(trace, 0);
}

}  // namespace poolhall::lab
