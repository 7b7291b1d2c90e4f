#pragma once

#include <functional>
#include <vector>

namespace poolhall::lab {

/// Where a search for a minimum goes.
struct SearchSpace {
    std::vector<double> start;
    std::vector<double> low;
    std::vector<double> high;
    std::vector<double> step;  ///< how far it first looks, not 0; the sign says which way
};

enum class SearchMethod {
    kQuadratic,  ///< Powell's BOBYQA: few evaluations where the function is smooth
    kSimplex,    ///< Rowan's Subplex: also where it is not
};

struct Minimum {
    std::vector<double> at;
    double value = 0;
};

/// The least value that so many evaluations find, by NLopt (S. G. Johnson,
/// github.com/stevengj/nlopt): local and without derivatives. Always the same for the same
/// function.
[[nodiscard]] Minimum minimise(SearchMethod method, const SearchSpace& space, int evaluations,
                               const std::function<double(const double* at)>& value);

}  // namespace poolhall::lab
