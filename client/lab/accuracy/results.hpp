#pragma once

#include "client/lab/output/build_info.hpp"
#include "client/lab/statistics/order_fit.hpp"
#include "client/lab/statistics/quantiles.hpp"
#include "shared/physics/scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

// What `poolhall-lab accuracy` finds. README.md here defines every quantity.
namespace poolhall::lab {

/// Of a shot, on the average over the shots that were timed.
struct ShotCost {
    double ns = 0;                       ///< CPU time, the median of the repeats
    std::optional<double> instructions;  ///< where the processor lets them be counted
    double worst_tick_ns = 0;            ///< CPU time of the worst 1/30 s of simulated time
    double ticks = 0;
    double events = 0;
};

/// One solver at one rate.
struct AccuracyPoint {
    SolverSpec solver;
    std::string kernel;
    ShotCost cost;
    Spread rest_error;  ///< m
    // Of the first impact; nothing where no shot has the same one as its reference.
    std::optional<Spread> impact_time_error;      ///< s
    std::optional<Spread> impact_place_error;     ///< m
    std::optional<Spread> impact_velocity_error;  ///< m/s
    Spread energy_drift;                          ///< relative to the energy at the beginning
    double matching_share = 0;           ///< of the references' events before the first difference
    double horizon_median = 0;           ///< s: when the first difference comes
    double verdict_flips = 0;            ///< share of shots
    std::optional<double> winner_flips;  ///< share of shots, where the ensemble has winners
    double missed = 0;                   ///< impacts of balls a shot
    double invented = 0;                 ///< impacts of balls a shot
};

/// A solver's order of convergence in one quantity.
struct OrderRow {
    SolverKind solver = SolverKind::kEuler;
    std::string quantity;
    std::optional<Order> order;  ///< nothing where the error has no asymptotic range
    double expected = 0;         ///< by theory
    std::string note;            ///< why it is not what theory expects; empty where it is
};

/// How the error grows within a shot.
struct ErrorInTime {
    SolverSpec solver;
    std::vector<double> t;       ///< s
    std::vector<double> median;  ///< m, of the ball that is farthest off
    std::vector<double> p90;     ///< m
};

struct EnsembleResult {
    std::string name;
    std::string title;
    std::size_t shots = 0;
    std::string reference;
    double reference_error = 0;  ///< estimated, m
    std::vector<AccuracyPoint> points;
    std::vector<OrderRow> orders;
    std::vector<ErrorInTime> error_in_time;
};

/// Impacts that a solver misses, by speed.
struct Tunnelling {
    SolverSpec solver;
    std::vector<double> speed;   ///< m/s
    std::vector<double> missed;  ///< share of true hits
};

/// What a shot costs as balls grow.
struct CrowdCosts {
    SolverSpec solver;
    std::vector<std::size_t> balls;
    std::vector<double> ns;
};

struct AccuracyResult {
    std::string command;
    std::uint64_t seed = 0;
    bool quick = false;
    bool complete = false;  ///< false: interrupted, and only what was finished is here
    double seconds = 0;     ///< that all of it took
    BuildInfo build;
    std::vector<EnsembleResult> ensembles;
    std::vector<Tunnelling> tunnelling;
    std::vector<CrowdCosts> crowds;
};

/// "poolhall.accuracy/1" (README.md).
void write_json(std::ostream& out, const AccuracyResult& result);
/// A line a point.
void write_csv(std::ostream& out, const AccuracyResult& result);

}  // namespace poolhall::lab
