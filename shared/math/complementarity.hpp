#pragma once

#include "shared/math/double_double.hpp"

#include <cstddef>
#include <vector>

namespace poolhall {

/// A linear complementarity problem: find x with 0 <= x, 0 <= G x + q, and for each i one of the
/// two equal to 0. G is symmetric and positive semidefinite. All in double-double, so that the
/// order of the unknowns leaves no trace in results that are rounded to doubles.
class ComplementarityProblem {
  public:
    /// No larger problem than this will use the heap.
    explicit ComplementarityProblem(std::size_t capacity);

    /// Begins a problem of `size` unknowns, all entries to be set.
    void reset(std::size_t size);

    [[nodiscard]] std::size_t size() const { return size_; }

    [[nodiscard]] DoubleDouble& g(std::size_t row, std::size_t column) {
        return g_[row * size_ + column];
    }

    [[nodiscard]] DoubleDouble& q(std::size_t row) { return q_[row]; }

    /// Murty's least-index principal pivoting (Murty, "Linear Complementarity, Linear and Nonlinear
    /// Programming", 1988, 4.1). Entries of G are of size 1 to 2.
    void solve();

    /// The solution, after solve().
    [[nodiscard]] DoubleDouble x(std::size_t row) const { return x_[row]; }

  private:
    void solve_basis();
    [[nodiscard]] bool violates(std::size_t row, Real tolerance) const;

    std::size_t size_ = 0;
    std::vector<DoubleDouble> g_;
    std::vector<DoubleDouble> q_;
    std::vector<DoubleDouble> x_;
    std::vector<DoubleDouble> rows_;
    std::vector<unsigned char> in_basis_;
    std::vector<std::size_t> basis_;
};

}  // namespace poolhall
