#include "client/lab/accuracy/error_in_time.hpp"

#include "client/lab/accuracy/true_course.hpp"
#include "client/lab/run/progress.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <array>

namespace poolhall::lab {

namespace {

constexpr std::size_t kMostShots = 200;

constexpr std::array kShown{
    SolverSpec{SolverKind::kEuler, 30},
    SolverSpec{SolverKind::kEuler, 120},
    SolverSpec{SolverKind::kEuler, 480},
    SolverSpec{SolverKind::kSemiImplicit, 30},
    SolverSpec{SolverKind::kExactArc, 30},
    SolverSpec{SolverKind::kOverlap, 30},
    SolverSpec{SolverKind::kEvent, SolverSpec{}.hz},
};

/// Of the ball that is farthest off at sample k; a trace that has ended keeps its last sample.
double distance_at(const ShotTrace& reference, const ShotTrace& other, std::size_t k) {
    const std::size_t i = std::min(k, reference.sample_count() - 1);
    const std::size_t j = std::min(k, other.sample_count() - 1);
    double farthest = 0;
    for (std::size_t ball = 0; ball < reference.balls.size(); ++ball)
        farthest = std::max(farthest, norm(reference.sample(i, ball) - other.sample(j, ball)));
    return farthest;
}

/// How many samples the shot lasts that is longer than half of the others.
std::size_t usual_samples(const std::vector<ShotTrace>& traces) {
    std::vector<double> counts;
    counts.reserve(traces.size());
    for (const ShotTrace& trace : traces)
        counts.push_back(static_cast<double>(trace.sample_count()));
    return static_cast<std::size_t>(spread_of(counts)->median);
}

ErrorInTime errors_of(const SolverSpec& solver, double sample_hz, std::span<const Scene> scenes,
                      const std::vector<ShotTrace>& references) {
    const std::size_t samples = usual_samples(references);
    std::vector<std::vector<double>> distances(samples);
    Simulator simulator;
    ShotTrace trace;
    for (std::size_t shot = 0; shot < scenes.size() && !Interruption::asked_for(); ++shot) {
        Scene scene = scenes[shot];
        scene.solver = solver;
        simulator.simulate(scene, sample_hz, trace);
        for (std::size_t k = 0; k < samples; ++k)
            distances[k].push_back(distance_at(references[shot], trace, k));
    }
    ErrorInTime errors{solver, {}, {}, {}};
    for (std::size_t k = 0; k < samples; ++k) {
        const auto spread = spread_of(distances[k]).value_or(Spread{});
        errors.t.push_back(static_cast<double>(k) / sample_hz);
        errors.median.push_back(spread.median);
        errors.p90.push_back(spread.p90);
    }
    return errors;
}

}  // namespace

std::vector<ErrorInTime> errors_in_time(const Ensemble& ensemble, std::span<const Scene> scenes) {
    const auto shown = scenes.first(std::min(scenes.size(), kMostShots));
    TrueCourse truth(ensemble.reference);
    std::vector<ShotTrace> references(shown.size());
    for (std::size_t shot = 0; shot < shown.size(); ++shot) {
        if (Interruption::asked_for()) return {};
        truth.simulate(shown[shot], ensemble.sample_hz, references[shot]);
    }
    std::vector<ErrorInTime> errors;
    for (const SolverSpec& solver : kShown) {
        Scene scene = shown[0];
        scene.solver = solver;
        if (!check(scene))
            errors.push_back(errors_of(solver, ensemble.sample_hz, shown, references));
    }
    return errors;
}

}  // namespace poolhall::lab
