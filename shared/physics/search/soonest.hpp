#pragma once

#include "shared/physics/motion/arc.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

namespace poolhall {

/// An instant a ball, and the soonest of them: few are looked through, many are the leaves of a
/// tournament, whose inner nodes hold the sooner of their two children.
class Soonest {
  public:
    struct Found {
        Real t = kNever;
        std::size_t ball = 0;   ///< the first that has t
        std::size_t count = 0;  ///< how many balls have t; not counted where t is kNever
    };

    /// All never. From `many` balls on they are many.
    void reset(std::size_t balls, std::size_t many) {
        is_tree_ = balls >= many;
        leaves_ = is_tree_ ? std::bit_ceil(balls) : 0;
        times_.assign(is_tree_ ? 2 * leaves_ : balls, kNever);
    }

    void set(std::size_t ball, Real t) {
        if (!is_tree_) {
            times_[ball] = t;
            return;
        }
        std::size_t node = leaves_ + ball;
        times_[node] = t;
        while (node > 1) {
            const Real sooner = std::min(times_[node], times_[node ^ 1]);
            node /= 2;
            if (times_[node] == sooner) return;
            times_[node] = sooner;
        }
    }

    [[nodiscard]] Found find() const { return is_tree_ ? winner() : least(); }

  private:
    [[nodiscard]] Found least() const {
        // No branches: who comes next cannot be foreseen.
        Found found;
        for (const Real t : times_)
            found.t = std::min(t, found.t);
        for (std::size_t i = times_.size(); i-- > 0;) {
            const bool has_it = times_[i] <= found.t;
            found.ball = has_it ? i : found.ball;
            found.count += has_it ? 1 : 0;
        }
        return found;
    }

    [[nodiscard]] Found winner() const {
        Found found{times_[1]};
        if (found.t < kNever) look_for(found, 1);
        return found;
    }

    /// Adds the leaves below `node` that have found.t.
    void look_for(Found& found, std::size_t node) const {
        if (times_[node] != found.t) return;
        if (node < leaves_) {
            look_for(found, 2 * node);
            look_for(found, 2 * node + 1);
            return;
        }
        if (found.count++ == 0) found.ball = node - leaves_;
    }

    bool is_tree_ = false;
    std::size_t leaves_ = 1;  ///< of the tree
    std::vector<Real>
        times_;  ///< a ball; as a tree, a node, the root at 1, node k's children at 2k
};

}  // namespace poolhall
