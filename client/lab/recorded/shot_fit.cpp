#include "client/lab/recorded/shot_fit.hpp"

#include "client/lab/recorded/minimise.hpp"

#include <algorithm>
#include <cmath>

namespace poolhall::lab {

namespace {

enum Parameter : std::size_t { kAim, kSpeed, kSide, kHeight, kDelay };

constexpr double kMiscue = 0.55;        ///< R
constexpr double kFarthest = 0.65;      ///< R, that a search may go
constexpr double kLongestDelay = 0.08;  ///< s
constexpr double kFastest = 9;          ///< m/s
constexpr double kSlowest = 0.2;        ///< m/s
constexpr double kLeastTime = 0.01;     ///< s, of a simulation

/// How far off a start may be that is worth a look.
constexpr std::array kReach{0.002, 0.02, 0.05, 0.05, 0.004};  ///< the speed's is relative

bool is_better(const ShotParameters& a, const ShotParameters& b) {
    return a.misfit < b.misfit;
}

/// Whether both are about the same shot.
bool is_same(const ShotParameters& a, const ShotParameters& b) {
    const auto apart = [&](std::size_t i) { return std::abs(a.values[i] - b.values[i]); };
    return apart(kAim) / 0.001 + apart(kSpeed) / (0.02 * b.values[kSpeed]) + apart(kSide) / 0.03 +
               apart(kHeight) / 0.03 <
           0.5;
}

/// Sorts, and leaves the best that differ.
void keep_best(std::vector<ShotParameters>& all, std::size_t count) {
    std::sort(all.begin(), all.end(), is_better);
    std::vector<ShotParameters> kept;
    for (const ShotParameters& one : all) {
        const bool is_new = std::none_of(kept.begin(), kept.end(),
                                         [&](const auto& other) { return is_same(one, other); });
        if (is_new && kept.size() < count) kept.push_back(one);
    }
    all = std::move(kept);
}

}  // namespace

ShotFit::ShotFit(const RecordedShot& shot, const TableConstants& constants)
    : shot_(shot), marks_(marks_of(shot)), scene_(scene_of(shot, constants)) {}

void ShotFit::simulate(const double* values, double until) {
    const double turn = values[kAim];
    const Vec2 d = marks_.direction;
    const Vec2 aim{std::cos(turn), std::sin(turn)};
    scene_.strike->direction = {d.x * aim.x - d.y * aim.y, d.x * aim.y + d.y * aim.x};
    scene_.strike->speed = values[kSpeed];
    const double offset = std::hypot(values[kSide], values[kHeight]);
    const double share = offset > kFarthest ? kFarthest / offset : 1;
    scene_.strike->offset = share * Vec2{values[kSide], values[kHeight]};
    scene_.limits.time = std::max(kLeastTime, until - values[kDelay]);
    simulator_.simulate(scene_, 0, trace_);
    courses_.set(scene_, trace_);
    ++simulations_;
}

double ShotFit::mean_square(double delay, double until, std::optional<std::size_t> ball) const {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < shot_.tracks.size(); ++i) {
        if (ball && i != *ball) continue;
        const RecordedTrack& track = shot_.tracks[i];
        const auto& course = courses_.of(i);
        std::size_t stretch = 0;
        for (std::size_t k = 0; k < track.t.size() && track.t[k] <= until; ++k) {
            const double t = std::clamp(track.t[k] - delay, 0.0, courses_.end());
            while (stretch + 1 < course.size() && course[stretch + 1].t <= t)
                ++stretch;
            const Vec2 off = place_on(course[stretch], t) - track.r[k];
            sum += dot(off, off);
            ++count;
        }
    }
    return sum / static_cast<double>(count);
}

double ShotFit::misfit(const double* values, double until) {
    simulate(values, until);
    const double beyond = std::max(0.0, std::hypot(values[kSide], values[kHeight]) - kMiscue);
    return std::sqrt(mean_square(values[kDelay], until, std::nullopt) +
                     mean_square(values[kDelay], std::min(until, marks_.third_rail), shot_.cue) +
                     beyond * beyond);
}

ShotFit::Distances ShotFit::distances(const ShotParameters& parameters) {
    simulate(parameters.values.data(), marks_.end);
    const double delay = parameters.values[kDelay];
    return {std::sqrt(mean_square(delay, marks_.end, std::nullopt)),
            std::sqrt(mean_square(delay, marks_.third_rail, shot_.cue))};
}

void ShotFit::refine(ShotParameters& parameters, double until, int evaluations, double scale) {
    constexpr double kWidest = 0.1;  // rad
    const auto& at = parameters.values;
    const SearchSpace space{
        {at.begin(), at.end()},
        {at[kAim] - kWidest, kSlowest, -kFarthest, -kFarthest, 0},
        {at[kAim] + kWidest, kFastest, kFarthest, kFarthest, kLongestDelay},
        {0.003 * scale, 0.1 * at[kSpeed] * scale, 0.1 * scale, 0.1 * scale, 0.008 * scale}};
    const Minimum found = minimise(SearchMethod::kQuadratic, space, evaluations,
                                   [&](const double* values) { return misfit(values, until); });
    std::copy(found.at.begin(), found.at.end(), parameters.values.begin());
    parameters.misfit = found.value;
}

void ShotFit::refine_all(std::vector<ShotParameters>& all, double until, int evaluations,
                         double scale) {
    for (ShotParameters& one : all)
        refine(one, until, evaluations, scale);
}

std::vector<ShotParameters> ShotFit::random_starts(const FitPlan& plan, Random& random) {
    std::vector<ShotParameters> starts(plan.starts);
    for (ShotParameters& start : starts) {
        const Vec2 offset = kMiscue * random.direction();
        start.values = {random.uniform(-0.006, 0.006), marks_.speed * random.uniform(0.9, 1.2),
                        offset.x, offset.y, random.uniform(0, 0.03)};
        start.misfit = misfit(start.values.data(), marks_.horizons.front());
    }
    std::sort(starts.begin(), starts.end(), is_better);
    if (starts.size() > plan.kept) starts.resize(plan.kept);
    return starts;
}

ShotParameters ShotFit::best_about(const ShotParameters& centre, double scale, Random& random) {
    constexpr int kTries = 60;
    ShotParameters best;
    for (int i = 0; i < kTries; ++i) {
        ShotParameters one = centre;
        for (std::size_t k = 0; k < kReach.size(); ++k) {
            const double reach = kReach[k] * (k == kSpeed ? centre.values[kSpeed] : 1);
            one.values[k] += scale * reach * random.uniform(-1, 1);
        }
        one.values[kDelay] = std::clamp(one.values[kDelay], 0.0, kLongestDelay);
        one.misfit = misfit(one.values.data(), marks_.end);
        if (i == 0 || is_better(one, best)) best = one;
    }
    return best;
}

std::vector<ShotParameters> ShotFit::from_scratch(const FitPlan& plan, std::uint64_t seed) {
    constexpr std::size_t kLeastKept = 4;
    constexpr int kFirst = 80;  // evaluations
    constexpr int kNext = 60;
    Random random(seed);
    std::vector<ShotParameters> all = random_starts(plan, random);
    std::size_t kept = plan.kept;
    for (std::size_t i = 0; i < marks_.horizons.size(); ++i) {
        refine_all(all, marks_.horizons[i], i == 0 ? kFirst : kNext, i == 0 ? 1 : 0.3);
        kept /= 2;
        keep_best(all, std::max(kept, kLeastKept));
    }
    for (int i = 0; i < plan.restarts; ++i) {
        ShotParameters one = best_about(all.front(), i % 2 == 0 ? 1 : 0.3, random);
        refine(one, marks_.end, kFirst, 0.1);
        all.push_back(one);
        std::sort(all.begin(), all.end(), is_better);
    }
    keep_best(all, kLeastKept);
    return all;
}

std::vector<ShotParameters> ShotFit::from_near(std::vector<ShotParameters> candidates) {
    constexpr int kEvaluations = 50;
    for (const double horizon : marks_.horizons)
        refine_all(candidates, horizon, kEvaluations, 0.1);
    keep_best(candidates, candidates.size());
    return candidates;
}

}  // namespace poolhall::lab
