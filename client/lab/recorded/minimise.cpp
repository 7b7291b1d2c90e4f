#include "client/lab/recorded/minimise.hpp"

#include <algorithm>
#include <memory>
#include <nlopt.h>

namespace poolhall::lab {

namespace {

using Value = std::function<double(const double* at)>;

/// The least of what was asked for, since a search may end at a worse point.
struct Best {
    const Value& value;
    Minimum found;
};

double note(unsigned count, const double* at, double* /*gradient*/, void* data) {
    auto& best = *static_cast<Best*>(data);
    const double value = best.value(at);
    if (best.found.at.empty() || value < best.found.value)
        best.found = {std::vector<double>(at, at + count), value};
    return value;
}

}  // namespace

Minimum minimise(SearchMethod method, const SearchSpace& space, int evaluations,
                 const Value& value) {
    constexpr double kGoodEnough = 1e-4;  // relative
    const auto algorithm = method == SearchMethod::kQuadratic ? NLOPT_LN_BOBYQA : NLOPT_LN_SBPLX;
    const auto count = static_cast<unsigned>(space.start.size());
    const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> search(nlopt_create(algorithm, count),
                                                                   nlopt_destroy);
    Best best{value, {}};
    std::vector<double> at = space.start;
    for (std::size_t i = 0; i < at.size(); ++i)
        at[i] = std::clamp(at[i], space.low[i], space.high[i]);
    nlopt_set_lower_bounds(search.get(), space.low.data());
    nlopt_set_upper_bounds(search.get(), space.high.data());
    nlopt_set_initial_step(search.get(), space.step.data());
    nlopt_set_maxeval(search.get(), evaluations);
    nlopt_set_ftol_rel(search.get(), kGoodEnough);
    nlopt_set_min_objective(search.get(), note, &best);
    double last = 0;
    // What it ends with says why it ended; a search that rounding stops has found its best, too.
    nlopt_optimize(search.get(), at.data(), &last);
    return best.found;
}

}  // namespace poolhall::lab
