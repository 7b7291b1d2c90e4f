#include "client/lab/validate/tables.hpp"
#include "shared/physics/simulate.hpp"

namespace poolhall::lab {

namespace {

// M09: on a snooker table, mu_r 0.0127 and mu_s 0.178 to 0.245 of gravity, m/s^2.
constexpr Published kRollingDeceleration{0.124, 0.126};
constexpr Published kSlidingDeceleration{1.75, 2.40};
constexpr double kMeasuredRolling = 0.0127;

// Jewett, Alciatore (second hand): seconds over 2.54 m to rest, on tournament cloth.
constexpr Published kLag{7, 9};
constexpr double kLagLength = 2.54;

// Alciatore (second hand): rad/s^2, of spin about the vertical.
constexpr Published kSpinDeceleration{5, 15};

Scene on_cloth(const BallState& state) {
    Scene scene;
    scene.table.rails = false;
    scene.effects.sliding = SlidingSpec{};
    scene.effects.rolling = RollingSpec{};
    scene.effects.spin_decay = SpinDecaySpec{};
    scene.solver.kind = SolverKind::kEvent;
    scene.balls = {{"cue", state}};
    return scene;
}

BallState rolling(double speed) {
    return {{}, {speed, 0, 0}, {0, speed / BallSpec{}.radius, 0}};
}

/// Of a rolling ball over its whole way, m/s^2.
double rolling_deceleration() {
    Scene scene = on_cloth(rolling(1));
    scene.effects.rolling->mu = kMeasuredRolling;
    return 0.5 / simulate(scene).balls[0].state.r.x;
}

/// Of a ball that begins without spin, until it rolls, m/s^2.
double sliding_deceleration() {
    const ShotTrace trace = simulate(on_cloth({{}, {1, 0, 0}, {}}));
    for (const ShotEvent& event : trace.events) {
        if (event.kind == EventKind::kSlideToRoll) return (1 - event.after[0].v.x) / event.t;
    }
    return 0;
}

/// How long a ball rolls that comes to rest after the length of the table, s.
double lag_time() {
    // Ways grow with the square of the speed, times with the speed.
    const ShotTrace trace = simulate(on_cloth(rolling(1)));
    const double way = trace.balls[0].state.r.x;
    const double share = kLagLength / way;
    const ShotTrace lag = simulate(on_cloth(rolling(sqrt(share))));
    return lag.duration;
}

/// rad/s^2.
double spin_deceleration() {
    constexpr double kSpin = 50;
    return kSpin / simulate(on_cloth({{}, {}, {0, 0, kSpin}})).duration;
}

MeasuredTable table_of(std::string name, std::string title, std::string unit) {
    return {.name = std::move(name),
            .title = std::move(title),
            .unit = std::move(unit),
            .source = "M09; Jewett and Alciatore (second hand)",
            .accuracy = "a range over tables and cloths",
            .note = "Parameters of the cloth: it shows that the defaults are those of real tables.",
            .models = {"default cloth"}};
}

}  // namespace

std::vector<MeasuredTable> cloth_tables() {
    MeasuredTable slow = table_of("cloth_deceleration", "Deceleration on the cloth", "m/s^2");
    slow.rows = {{"rolling, mu 0.0127", kRollingDeceleration, false, {rolling_deceleration()}},
                 {"sliding, mu 0.2", kSlidingDeceleration, false, {sliding_deceleration()}}};
    MeasuredTable lag = table_of("lag", "Lag: a roll of 2.54 m to rest", "s");
    lag.rows = {{"mu 0.01", kLag, false, {lag_time()}}};
    MeasuredTable spin = table_of("spin_decay", "Spin about the vertical, in place", "rad/s^2");
    spin.rows = {{"mu 0.0127", kSpinDeceleration, false, {spin_deceleration()}}};
    return {slow, lag, spin};
}

}  // namespace poolhall::lab
