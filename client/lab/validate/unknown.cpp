#include "client/lab/validate/unknown.hpp"

#include "client/lab/ensembles/ensembles.hpp"
#include "shared/analysis/agreement.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <array>

namespace poolhall::lab {

namespace {

constexpr double kPlacement = 1e-4;  ///< m: what a careful hand can do

// Spreads of measurements, as shares of the middle: M09 has sliding friction from 0.178 to 0.245;
// lags of 7 to 9 s (Jewett, Alciatore) are rolling friction of 0.0064 to 0.0106; spin about the
// vertical falls with 5 to 15 rad/s^2 (Alciatore); balls part with e of 0.92 to 0.98 and mu of 0.03
// to 0.08 (Alciatore); M09's ratios at a rail go from 0.80 to 0.95.
constexpr double kSliding = 0.16;
constexpr double kRolling = 0.25;
constexpr double kSpin = 0.5;
constexpr double kBallRestitution = 0.03;
constexpr double kBallFriction = 0.45;
constexpr double kRailRestitution = 0.08;
constexpr double kRailFriction = 0.3;

constexpr std::array kErrors{1e-12, 1e-10, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3};  ///< m
constexpr std::array kBreaks{"nine_ball_break", "fifteen_ball_break"};

/// Balls up to `most` m from where they were; touching balls stay apart.
Scene misplaced(Scene scene, double most, Random& random) {
    const Vec2 edge = inset(scene.table, scene.ball.radius);
    for (SceneBall& ball : scene.balls) {
        const Vec2 place = xy(ball.state.r) + most * random.direction();
        set_xy(ball.state.r,
               {std::clamp(place.x, -edge.x, edge.x), std::clamp(place.y, -edge.y, edge.y)});
    }
    constexpr int kRounds = 50;
    for (int i = 0; i < kRounds; ++i) {
        for (std::size_t a = 0; a < scene.balls.size(); ++a) {
            for (std::size_t b = a + 1; b < scene.balls.size(); ++b) {
                Vec3& r_a = scene.balls[a].state.r;
                Vec3& r_b = scene.balls[b].state.r;
                const Vec2 way = xy(r_b) - xy(r_a);
                const double least = 2 * scene.ball.radius * (1 + 1e-12);
                const double distance = norm(way);
                if (distance >= least) continue;
                const Vec2 half = ((least - distance) / 2 + 1e-13) / distance * way;
                set_xy(r_a, xy(r_a) - half);
                set_xy(r_b, xy(r_b) + half);
            }
        }
    }
    return scene;
}

Scene on_another_table(Scene scene, Random& random) {
    const auto vary = [&](double& value, double share) {
        value *= 1 + random.uniform(-share, share);
    };
    Effects& effects = scene.effects;
    if (effects.sliding) vary(effects.sliding->mu, kSliding);
    if (effects.rolling) vary(effects.rolling->mu, kRolling);
    if (effects.spin_decay) vary(effects.spin_decay->mu, kSpin);
    if (effects.ball_ball.model != BallBallModel::kElastic) {
        vary(effects.ball_ball.e, kBallRestitution);
        effects.ball_ball.e = std::min(effects.ball_ball.e, 1.0);
        vary(effects.ball_ball.mu, kBallFriction);
        if (auto& law = effects.ball_ball.friction_by_speed) vary(law->b, kBallFriction);
    }
    if (effects.rail.model != RailModel::kElastic) {
        const double rail_e = effects.rail.e;
        vary(effects.rail.e, kRailRestitution);
        effects.rail.e = std::min(effects.rail.e, 1.0);
        if (auto& law = effects.rail.e_by_speed) law->e *= effects.rail.e / rail_e;
        vary(effects.rail.mu, kRailFriction);
    }
    return scene;
}

double median_of(std::vector<double> values) {
    return spread_of(std::move(values))->median;
}

Unknown find_unknown(const Ensemble& ensemble, std::uint64_t seed, std::size_t shots) {
    Random random(seed);
    std::vector<double> placement;
    std::vector<double> coefficients;
    const auto scenes = scenes_of(ensemble, seed, std::min(shots, ensemble.shots));
    for (const Scene& scene : scenes) {
        const ShotTrace trace = simulate(scene);
        const auto off = [&](const Scene& other) {
            return analysis::farthest_at_rest(trace, simulate(other));
        };
        placement.push_back(off(misplaced(scene, kPlacement, random)));
        coefficients.push_back(off(on_another_table(scene, random)));
    }
    return {std::string(ensemble.name), scenes.size(), spread_of(placement).value(),
            spread_of(coefficients).value()};
}

}  // namespace

std::vector<Unknown> find_unknowns(std::uint64_t seed, std::size_t shots) {
    std::vector<Unknown> all;
    for (const Ensemble& ensemble : ensembles())
        all.push_back(find_unknown(ensemble, seed, shots));
    return all;
}

std::vector<HorizonByError> find_horizons(std::uint64_t seed, std::size_t shots) {
    std::vector<HorizonByError> all;
    for (const char* name : kBreaks) {
        Random random(seed);
        const auto scenes = scenes_of(*find_ensemble(name), seed, shots);
        HorizonByError& found = all.emplace_back(HorizonByError{name, shots, {}, {}, {}});
        for (const double error : kErrors) {
            std::vector<double> horizons;
            std::vector<double> durations;
            for (const Scene& scene : scenes) {
                const ShotTrace trace = simulate(scene);
                const ShotTrace other = simulate(misplaced(scene, error, random));
                horizons.push_back(analysis::agreement(trace, other).horizon);
                durations.push_back(trace.duration);
            }
            found.input_error.push_back(error);
            found.horizon.push_back(median_of(horizons));
            found.duration.push_back(median_of(durations));
        }
    }
    return all;
}

}  // namespace poolhall::lab
