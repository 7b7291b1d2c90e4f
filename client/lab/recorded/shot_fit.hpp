#pragma once

#include "client/lab/corpora/random.hpp"
#include "client/lab/recorded/ball_courses.hpp"
#include "client/lab/recorded/marks.hpp"
#include "client/lab/recorded/recording.hpp"
#include "client/lab/recorded/table_constants.hpp"
#include "shared/physics/simulate.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace poolhall::lab {

/// What is fitted of each shot.
struct ShotParameters {
    /// Turn of the aim from the mark's direction, rad; speed, m/s; side and height of the tip,
    /// radii; how long the ball lay still at first, s.
    std::array<double, 5> values = {};
    double misfit = 0;  ///< m; what the fit makes small (ShotFit)
};

/// How thorough a fit is.
struct FitPlan {
    std::size_t starts = 0;  ///< random ones
    std::size_t kept = 0;    ///< of them, to go on with
    int restarts = 0;        ///< about the best, at last
};

/// Fits one shot under fixed constants. The misfit is the root of the mean square distance of all
/// balls from their samples over the whole shot and that of the cue ball up to its third rail,
/// added. Offsets beyond a miscue (0.55 R) count against a fit.
///
/// Shots are chaotic, so the fit goes from contact to contact: many random starts are judged by the
/// first, the best of them refined and judged by the next, and so on to the end.
class ShotFit {
  public:
    ShotFit(const RecordedShot& shot, const TableConstants& constants);

    /// From random starts; always the same for the same `seed`.
    [[nodiscard]] std::vector<ShotParameters> from_scratch(const FitPlan& plan, std::uint64_t seed);
    /// From good ones of much the same constants. Best first, like those above.
    [[nodiscard]] std::vector<ShotParameters> from_near(std::vector<ShotParameters> candidates);

    /// Root mean square distances of a fit, m.
    struct Distances {
        double whole = 0;          ///< all balls, whole shot
        double to_third_rail = 0;  ///< cue ball, up to its third rail
    };

    [[nodiscard]] Distances distances(const ShotParameters& parameters);

    [[nodiscard]] std::size_t simulations() const { return simulations_; }

  private:
    void simulate(const double* values, double until);
    /// Mean square distance of one ball's samples or, without, of all balls', m^2.
    [[nodiscard]] double mean_square(double delay, double until,
                                     std::optional<std::size_t> ball) const;
    [[nodiscard]] double misfit(const double* values, double until);
    void refine(ShotParameters& parameters, double until, int evaluations, double scale);
    void refine_all(std::vector<ShotParameters>& all, double until, int evaluations, double scale);
    [[nodiscard]] std::vector<ShotParameters> random_starts(const FitPlan& plan, Random& random);
    [[nodiscard]] ShotParameters best_about(const ShotParameters& centre, double scale,
                                            Random& random);

    const RecordedShot& shot_;
    ShotMarks marks_;
    Scene scene_;
    Simulator simulator_;
    ShotTrace trace_;
    BallCourses courses_;
    std::size_t simulations_ = 0;
};

}  // namespace poolhall::lab
