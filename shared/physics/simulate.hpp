#pragma once

#include "shared/physics/called_for/reach.hpp"
#include "shared/physics/check.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"
#include "shared/physics/solvers/shot_run.hpp"
#include "shared/physics/solvers/solver.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace poolhall {

/// Rate at which shots are shown and broadcast, 1/s.
inline constexpr Real kPlayoutHz = 30;

/// Simulates shots one after another in the same memory: a shot that needs no more of it than an
/// earlier one allocates nothing, given a trace that has room.
class Simulator {
  public:
    Simulator() = default;

    /// With another number for kManyBalls, to measure it: the shots are the same.
    explicit Simulator(std::size_t many_balls) { workspace_.many_balls = many_balls; }

    /// Simulates the scene from its strike (or from the balls' own velocities) until nothing moves
    /// or a limit is reached. `sample_hz` > 0 also fills trace.samples with positions at
    /// k / sample_hz, k = 0, 1, ... up to the first at or after the end. The trace is overwritten;
    /// its memory is used again. The scene must have passed check().
    void simulate(const Scene& scene, Real sample_hz, ShotTrace& trace);

    /// One shot for each strike from the same position: traces[i] is what simulate() makes of the
    /// scene with strikes[i], to the last bit, so work may be split in any way between simulators.
    /// What does not depend on the strike is done once. There are as many traces as strikes.
    void simulate_many(const Scene& position, std::span<const Strike> strikes, Real sample_hz,
                       std::span<ShotTrace> traces);

    /// simulate() by the kernel of that name. False, and the trace untouched, if there is none or
    /// it does not cover the scene.
    [[nodiscard]] bool simulate_by(std::string_view kernel, const Scene& scene, Real sample_hz,
                                   ShotTrace& trace);

  private:
    void run(std::size_t kernel, ShotRun& shot, ShotTrace& trace);
    template <class Begin>
    void simulate_what_may_act(Begin begin, ShotTrace& trace);
    bool simulate_within_bounds(std::size_t kernel, const Scene& scene, Real sample_hz,
                                ShotTrace& trace);

    Workspace workspace_;
    ReachMemory reach_;
    std::vector<MovingBall> placed_;  ///< of simulate_many()
    std::array<SolverMemory, kCount<SolverKind>> memories_;
};

/// The same once, in memory of its own.
void simulate(const Scene& scene, Real sample_hz, ShotTrace& trace);
[[nodiscard]] ShotTrace simulate(const Scene& scene, Real sample_hz = 0);
[[nodiscard]] bool simulate_by(std::string_view kernel, const Scene& scene, Real sample_hz,
                               ShotTrace& trace);

/// Whether the solver goes by ticks, SolverSpec::hz a second.
[[nodiscard]] bool has_ticks(SolverKind kind);

/// The kernels (sets of effects compiled together), cheapest first. simulate() takes the first that
/// covers the scene; all that do give the same trace but for its `kernel`.
[[nodiscard]] std::span<const std::string_view> kernel_names();

}  // namespace poolhall
