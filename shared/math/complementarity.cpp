#include "shared/math/complementarity.hpp"

#include <algorithm>

namespace poolhall {

namespace {

/// Far more pivots than any group of contacts has needed.
constexpr int kMaxPivots = 1000;
/// Pivots smaller than this (of entries of size 1 to 2) mean that a row is redundant; rates within
/// this share of the largest q are rounding.
constexpr Real kSingular = 1e-12 * kFineness;

}  // namespace

ComplementarityProblem::ComplementarityProblem(std::size_t capacity) {
    g_.reserve(capacity * capacity);
    q_.reserve(capacity);
    x_.reserve(capacity);
    rows_.reserve(capacity * (capacity + 1));
    in_basis_.reserve(capacity);
    basis_.reserve(capacity);
}

void ComplementarityProblem::reset(std::size_t size) {
    size_ = size;
    g_.assign(size * size, {});
    q_.assign(size, {});
    x_.assign(size, {});
    in_basis_.assign(size, 1);
}

void ComplementarityProblem::solve() {
    Real largest = 0;
    for (const DoubleDouble& q : q_)
        largest = std::max(largest, abs(q.hi));
    for (int pivot = 0; pivot < kMaxPivots; ++pivot) {
        solve_basis();
        std::size_t wrong = 0;
        while (wrong < size_ && !violates(wrong, kSingular * largest))
            ++wrong;
        if (wrong == size_) break;
        in_basis_[wrong] = in_basis_[wrong] != 0 ? 0 : 1;
    }
}

/// Solves the principal system G x = -q of the basis by elimination; redundant rows get 0. G is
/// positive semidefinite: its diagonal serves as pivots.
void ComplementarityProblem::solve_basis() {
    basis_.clear();
    for (std::size_t i = 0; i < size_; ++i) {
        x_[i] = {};
        if (in_basis_[i] != 0) basis_.push_back(i);
    }
    const std::size_t n = basis_.size();
    const std::size_t width = n + 1;
    rows_.resize(n * width);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j)
            rows_[i * width + j] = g(basis_[i], basis_[j]);
        rows_[i * width + n] = -q_[basis_[i]];
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (rows_[i * width + i].hi < kSingular) continue;
        for (std::size_t k = 0; k < n; ++k) {
            if (k == i) continue;
            const DoubleDouble factor = rows_[k * width + i] / rows_[i * width + i];
            for (std::size_t j = i; j <= n; ++j)
                rows_[k * width + j] = rows_[k * width + j] - factor * rows_[i * width + j];
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        const DoubleDouble pivot = rows_[i * width + i];
        if (pivot.hi >= kSingular) x_[basis_[i]] = rows_[i * width + n] / pivot;
    }
}

/// Whether row i breaks its condition: a negative x, or a rate that is still negative.
bool ComplementarityProblem::violates(std::size_t row, Real tolerance) const {
    if (in_basis_[row] != 0) return x_[row].hi < 0;
    DoubleDouble rate = q_[row];
    for (std::size_t j = 0; j < size_; ++j)
        rate = rate + g_[row * size_ + j] * x_[j];
    return rate.hi < -tolerance;
}

}  // namespace poolhall
