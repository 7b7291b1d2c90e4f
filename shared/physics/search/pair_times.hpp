#pragma once

#include "shared/physics/motion/arc.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poolhall {

/// When each two balls meet, and for each ball who is first. Most pairs never meet, so a row is
/// walked by the bits of those that do.
class PairTimes {
  public:
    void reset(std::size_t balls) {
        size_ = balls;
        words_ = (balls + kBits - 1) / kBits;
        times_.resize(balls * balls);
        meets_.assign(balls * words_, 0);
        first_.assign(balls, kNever);
        partner_.assign(balls, 0);
    }

    [[nodiscard]] Real first(std::size_t ball) const { return first_[ball]; }

    /// Who meets the ball first, where anybody does.
    [[nodiscard]] std::size_t partner(std::size_t ball) const { return partner_[ball]; }

    /// Two balls meet at t, which is not kNever.
    void set(std::size_t a, std::size_t b, Real t) {
        set_one(a, b, t);
        set_one(b, a, t);
    }

    /// The ball meets nobody, until set anew. Calls changed(other) for those whose first it was.
    template <class Changed>
    void forget(std::size_t ball, Changed changed) {
        for_each_partner(ball, [&](std::size_t other, Real) {
            meets_[other * words_ + ball / kBits] &= ~bit_of(ball);
            if (partner_[other] != ball) return;
            find_first(other);
            changed(other);
        });
        for (std::size_t word = 0; word < words_; ++word)
            meets_[ball * words_ + word] = 0;
        first_[ball] = kNever;
    }

    /// Sets the clock of all times back, s.
    void set_back(Real passed) {
        for (std::size_t ball = 0; ball < size_; ++ball) {
            first_[ball] -= passed;
            for_each_partner(ball, [&](std::size_t other, Real t) {
                times_[ball * size_ + other] = t - passed;
            });
        }
    }

    /// Calls visit(other, t) for all that the ball meets, in their order.
    template <class Visit>
    void for_each_partner(std::size_t ball, Visit visit) const {
        for (std::size_t word = 0; word < words_; ++word) {
            for (std::uint64_t bits = meets_[ball * words_ + word]; bits != 0; bits &= bits - 1) {
                const std::size_t other =
                    word * kBits + static_cast<std::size_t>(std::countr_zero(bits));
                visit(other, times_[ball * size_ + other]);
            }
        }
    }

  private:
    static constexpr std::size_t kBits = 64;

    static constexpr std::uint64_t bit_of(std::size_t ball) {
        return std::uint64_t{1} << (ball % kBits);
    }

    void set_one(std::size_t ball, std::size_t other, Real t) {
        times_[ball * size_ + other] = t;
        meets_[ball * words_ + other / kBits] |= bit_of(other);
        if (t >= first_[ball]) return;
        first_[ball] = t;
        partner_[ball] = other;
    }

    void find_first(std::size_t ball) {
        first_[ball] = kNever;
        for_each_partner(ball, [&](std::size_t other, Real t) {
            if (t >= first_[ball]) return;
            first_[ball] = t;
            partner_[ball] = other;
        });
    }

    std::size_t size_ = 0;
    std::size_t words_ = 0;             ///< of bits a row
    std::vector<Real> times_;           ///< square, symmetric; holds where meets_ has a bit
    std::vector<std::uint64_t> meets_;  ///< a row of bits a ball
    std::vector<Real> first_;
    std::vector<std::size_t> partner_;
};

}  // namespace poolhall
