#include "client/desktop/app/solver_overlay.hpp"

#include "client/compare/number_text.hpp"
#include "shared/analysis/agreement.hpp"

#include <array>
#include <chrono>

namespace poolhall::client {
namespace {

/// All that the overlay can show; all of them run, so that F5 changes from set to set at once.
constexpr std::array<SolverSpec, 7> kEntrants{{{SolverKind::kEvent},
                                               {SolverKind::kEuler, 30},
                                               {SolverKind::kOverlap, 30},
                                               {SolverKind::kEuler, 120},
                                               {SolverKind::kEuler, 480},
                                               {SolverKind::kSemiImplicit, 30},
                                               {SolverKind::kExactArc, 30}}};

using SolverSet = std::array<std::size_t, 3>;
constexpr std::array<SolverSet, 3> kSets{{{0, 1, 2}, {1, 3, 4}, {0, 5, 6}}};

constexpr compare::ComparisonLimits kLimits{.sample_hz = 120, .repeats = 5, .max_cpu_ns = 1e6};
constexpr double kFinest = 2e-4;  // m; of the paths' drawing
constexpr double kSeen = 1e-5;    // m; smaller distances are not told

/// "euler 30 Hz".
std::string words_of(const SolverSpec& solver) {
    std::string words = compare::label(solver);
    const std::size_t colon = words.find(':');
    return colon == std::string::npos ? words : words.replace(colon, 1, " ") + " Hz";
}

std::string distance_of(const compare::Comparison& comparison, const compare::SolverRun& run) {
    const compare::SolverRun& reference = comparison.runs[*comparison.reference];
    if (&run == &reference) return "the reference";
    const bool same = analysis::is_same_verdict(reference.trace, run.trace);
    const double distance = compare::farthest_ball(run)->distance;
    const std::string off = distance < kSeen ? "under " + compare::text_of_distance(kSeen)
                                             : compare::text_of_distance(distance);
    const std::string said = off + " off " + compare::label(reference.solver);
    return same ? said : said + ", other balls down";
}

}  // namespace

void SolverOverlay::cycle() {
    chosen_ = (chosen_ + 1) % (kSets.size() + 1);
    start();
}

std::string SolverOverlay::description() const {
    if (chosen_ == 0) return "Other solvers: off";
    std::string names;
    for (const std::size_t entrant : kSets[chosen_ - 1])
        names += (names.empty() ? "" : ", ") + words_of(kEntrants[entrant]);
    const bool known = shot_ && scene_.strike;
    return "Other solvers: " + names + (known ? "" : "; from the next shot on");
}

void SolverOverlay::follow(const Shot& shot) {
    if (shot_ == shot.number) return;
    shot_ = shot.number;
    scene_ = shot.scene;
    start();
}

void SolverOverlay::start() {
    if (chosen_ == 0 || !shot_ || !scene_.strike) return;
    if (running_.valid() || done_.shot == *shot_) return;
    running_ = std::async(std::launch::async, [scene = scene_, shot = *shot_] {
        return Entries{shot, entries_of(scene)};
    });
}

bool SolverOverlay::poll() {
    using namespace std::chrono_literals;
    if (!running_.valid() || running_.wait_for(0s) != std::future_status::ready) return false;
    done_ = running_.get();
    start();  // another shot may have begun meanwhile
    return true;
}

std::vector<SolverOverlay::Entry> SolverOverlay::entries_of(const Scene& scene) {
    const compare::Comparison comparison = compare::compare_solvers(scene, kEntrants, kLimits);
    std::vector<Entry> entries;
    for (const compare::SolverRun& run : comparison.runs)
        entries.push_back(entry_of(scene, comparison, run));
    return entries;
}

SolverOverlay::Entry SolverOverlay::entry_of(const Scene& scene,
                                             const compare::Comparison& comparison,
                                             const compare::SolverRun& run) {
    Entry entry;
    entry.view.name = words_of(run.solver);
    entry.view.decides = run.solver == scene.solver;
    if (run.refusal) {
        entry.view.distance = "cannot do these effects";
        return entry;
    }
    entry.view.cost = compare::text_of_cost(run.cpu_ns);
    entry.view.distance = distance_of(comparison, run);
    for (analysis::Path& path : analysis::paths_of(scene, run.trace)) {
        auto outline = analysis::outline_of(path, kFinest);
        if (outline.size() < 2 || (outline.size() == 2 && outline[0] == outline[1])) continue;
        entry.view.paths.push_back(std::move(outline));
        entry.paths.push_back(std::move(path));
    }
    return entry;
}

std::vector<SolverView> SolverOverlay::view(double t) const {
    std::vector<SolverView> views;
    if (chosen_ == 0 || !shot_ || done_.shot != *shot_) return views;
    for (const std::size_t entrant : kSets[chosen_ - 1]) {
        const Entry& entry = done_.entries[entrant];
        views.push_back(entry.view);
        for (const analysis::Path& path : entry.paths)
            views.back().balls.push_back(analysis::place_at(path, t));
    }
    return views;
}

}  // namespace poolhall::client
