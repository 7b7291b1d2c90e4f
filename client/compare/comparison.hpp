#pragma once

#include "shared/analysis/agreement.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

// One scene by several solvers: what each makes of it, and what that costs.
namespace poolhall::compare {

struct SolverRun {
    SolverSpec solver;
    /// Why the solver does not take the scene; then there is nothing below.
    std::optional<SceneError> refusal;
    ShotTrace trace;    ///< with samples
    double cpu_ns = 0;  ///< CPU time of the shot without samples, the shortest of the repeats
    /// From where the reference has the ball in the end, m; in the scene's order of balls.
    std::vector<double> rest_distance;
    analysis::Agreement agreement;  ///< of its events with the reference's
};

struct Comparison {
    std::vector<SolverRun> runs;           ///< in the order asked for
    std::optional<std::size_t> reference;  ///< the most accurate of them; none if all refuse
};

/// What a comparison may cost.
struct ComparisonLimits {
    double sample_hz = 120;   ///< of the traces; fewer where a trace would hold over kMaxPlaces
    int repeats = 5;          ///< of each shot whose time is taken; one more warms up
    double max_cpu_ns = 2e7;  ///< CPU time; beyond it a shot is not repeated
};

/// As many places of balls as a trace's samples may hold: 24 MB.
inline constexpr double kMaxPlaces = 1e6;

/// Simulates the scene by each of the solvers instead of its own. The scene must pass check() with
/// one of them; a solver with which it does not is said to refuse it.
[[nodiscard]] Comparison compare_solvers(Scene scene, std::span<const SolverSpec> solvers,
                                         const ComparisonLimits& limits = {});

/// "event", "euler:30": as the lab's options name a solver.
[[nodiscard]] std::string label(const SolverSpec& solver);

/// The largest of the rest distances, m, and its ball; nothing for a refusal.
struct FarthestBall {
    BallIndex ball;
    double distance = 0;
};

[[nodiscard]] std::optional<FarthestBall> farthest_ball(const SolverRun& run);

}  // namespace poolhall::compare
