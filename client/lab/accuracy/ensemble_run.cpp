#include "client/lab/accuracy/ensemble_run.hpp"

#include "client/lab/accuracy/error_in_time.hpp"
#include "client/lab/accuracy/orders.hpp"
#include "client/lab/accuracy/point_errors.hpp"
#include "client/lab/accuracy/shot_cost.hpp"
#include "client/lab/accuracy/true_course.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <cmath>

namespace poolhall::lab {

namespace {

/// Numbers that are off by rounding to doubles: half a unit in the last place of 1 to 2 m.
constexpr double kRounding = 0x1p-53;
/// How much finer 113 bits round than doubles do.
constexpr double kFiner = 0x1p-60;

/// What is known of one solver while the shots go by.
struct Contestant {
    SolverSpec solver;
    PointErrors errors;
    Window busiest;
    double ns = 0;  ///< of all shots, once each and cold
};

/// All solvers on the shots of one ensemble.
class EnsembleRun {
  public:
    EnsembleRun(const Ensemble& ensemble, const RunPlan& plan, Progress& progress)
        : ensemble_(ensemble), plan_(plan), progress_(progress), truth_(ensemble.reference) {
        const std::size_t usual = plan.quick ? ensemble.quick_shots : ensemble.shots;
        scenes_ = scenes_of(ensemble, plan.seed, plan.shots > 0 ? plan.shots : usual);
        for (const SolverSpec& solver : solvers_for(ensemble, scenes_[0], plan))
            contestants_.push_back({solver, {}, {}, 0});
    }

    std::optional<EnsembleResult> run() {
        progress_.begin(std::string(ensemble_.name) + ": errors", scenes_.size());
        for (std::size_t shot = 0; shot < scenes_.size(); ++shot) {
            if (!run_shot(shot)) return std::nullopt;
            progress_.step();
        }
        EnsembleResult result;
        progress_.begin(std::string(ensemble_.name) + ": costs", contestants_.size());
        for (const Contestant& contestant : contestants_) {
            if (Interruption::asked_for()) return std::nullopt;
            result.points.push_back(point_of(contestant));
            progress_.step();
        }
        progress_.begin(std::string(ensemble_.name) + ": errors in time", 1);
        result.error_in_time = errors_in_time(ensemble_, scenes_);
        if (Interruption::asked_for()) return std::nullopt;
        describe(result);
        return result;
    }

  private:
    /// False if it was interrupted.
    bool run_shot(std::size_t shot) {
        Scene scene = scenes_[shot];
        truth_.simulate(scene, 0, reference_);
        const auto winner = winner_of(ensemble_, scene, reference_);
        for (Contestant& contestant : contestants_) {
            if (Interruption::asked_for()) return false;
            scene.solver = contestant.solver;
            const double start = cpu_time_ns();
            simulator_.simulate(scene, 0, trace_);
            contestant.ns += cpu_time_ns() - start;
            contestant.errors.add(errors_of(scene, reference_, trace_), trace_,
                                  reference_.events.size());
            if (ensemble_.winner != WinnerRule::kNone)
                contestant.errors.add_winner(winner_of(ensemble_, scene, trace_) != winner);
            note_busiest(trace_, contestant.solver, shot, contestant.busiest);
        }
        return true;
    }

    [[nodiscard]] AccuracyPoint point_of(const Contestant& contestant) const {
        AccuracyPoint point;
        point.solver = contestant.solver;
        const double ns_a_shot = contestant.ns / static_cast<double>(scenes_.size());
        point.cost =
            cost_of_shots(scenes_, point.solver, ns_a_shot, contestant.busiest, plan_.repeats());
        contestant.errors.write(point);
        return point;
    }

    void describe(EnsembleResult& result) const {
        result.name = ensemble_.name;
        result.title = ensemble_.title;
        result.shots = scenes_.size();
        result.reference = truth_.name();
        // 113 bits lose digits to chaos as doubles do: as many.
        result.reference_error = std::max(kRounding, kFiner * result.points.back().rest_error.p90);
        result.orders = fitted_orders(result.points);
    }

    const Ensemble& ensemble_;
    const RunPlan& plan_;
    Progress& progress_;
    TrueCourse truth_;
    std::vector<Scene> scenes_;
    std::vector<Contestant> contestants_;
    Simulator simulator_;
    ShotTrace reference_;
    ShotTrace trace_;
};

}  // namespace

std::vector<SolverSpec> solvers_for(const Ensemble& ensemble, Scene scene, const RunPlan& plan) {
    std::vector<SolverSpec> solvers;
    const int lowest = plan.quick ? 30 : 15;
    const int highest = plan.quick ? ensemble.quick_max_hz : 7680;
    for (const SolverKind kind : {SolverKind::kEuler, SolverKind::kSemiImplicit,
                                  SolverKind::kExactArc, SolverKind::kOverlap}) {
        for (int hz = lowest; hz <= highest; hz *= 2) {
            scene.solver = {kind, static_cast<double>(hz)};
            if (!check(scene)) solvers.push_back(scene.solver);
        }
    }
    solvers.push_back({SolverKind::kEvent, SolverSpec{}.hz});
    return solvers;
}

std::optional<EnsembleResult> run_ensemble(const Ensemble& ensemble, const RunPlan& plan,
                                           Progress& progress) {
    return EnsembleRun(ensemble, plan, progress).run();
}

}  // namespace poolhall::lab
