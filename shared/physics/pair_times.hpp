#pragma once

#include "shared/physics/arc.hpp"

#include <cstddef>
#include <vector>

namespace poolhall {

/// When each two balls meet, and for each ball who is first.
class PairTimes {
  public:
    void reset(std::size_t balls) {
        size_ = balls;
        times_.assign(balls * balls, kNever);
        first_.assign(balls, kNever);
        partner_.assign(balls, 0);
    }

    [[nodiscard]] double first(std::size_t ball) const { return first_[ball]; }

    /// Who meets the ball first, where anybody does.
    [[nodiscard]] std::size_t partner(std::size_t ball) const { return partner_[ball]; }

    [[nodiscard]] double at(std::size_t a, std::size_t b) const { return times_[a * size_ + b]; }

    /// Before all times of a ball are set anew.
    void forget(std::size_t ball) {
        first_[ball] = kNever;
        partner_[ball] = ball;
    }

    void set(std::size_t a, std::size_t b, double t) {
        // Most pairs never meet, before and after.
        if (t == times_[a * size_ + b] && t == kNever) return;
        times_[a * size_ + b] = t;
        times_[b * size_ + a] = t;
        update(a, b, t);
        update(b, a, t);
    }

  private:
    void update(std::size_t ball, std::size_t other, double t) {
        if (t < first_[ball]) {
            first_[ball] = t;
            partner_[ball] = other;
        } else if (partner_[ball] == other && t != first_[ball]) {
            find_first(ball);
        }
    }

    void find_first(std::size_t ball) {
        const double* row = &times_[ball * size_];
        first_[ball] = kNever;
        for (std::size_t i = 0; i < size_; ++i) {
            if (row[i] < first_[ball]) {
                first_[ball] = row[i];
                partner_[ball] = i;
            }
        }
    }

    std::size_t size_ = 0;
    std::vector<double> times_;  ///< square, symmetric
    std::vector<double> first_;
    std::vector<std::size_t> partner_;
};

}  // namespace poolhall
