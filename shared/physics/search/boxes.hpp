#pragma once

#include "shared/physics/search/box.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poolhall {

/// The boxes of all balls, and which of them overlap.
///
/// A side is kept to 15 bits, and the four sides of a box in one word: low x, low y, and high x and
/// high y counted from the other end. Two boxes overlap if no low side is above the other's high
/// one: four comparisons, which one subtraction of words makes whose fields have a bit to spare.
/// Rounding keeps the order of sides, so no overlap is lost.
///
/// Few boxes are looked through. Many are first sifted: the room is cut into columns and rows, each
/// of which holds a bit a ball, and what overlaps a box shares a column and a row with it.
class Boxes {
  public:
    /// No boxes. Sides are told apart best within `room`; what is beyond counts as at its edge.
    /// From `many` balls on they are many.
    void reset(std::size_t balls, const Box& room, std::size_t many) {
        room_ = room;
        per_metre_x_ = kSteps / (room.high_x - room.low_x);
        per_metre_y_ = kSteps / (room.high_y - room.low_y);
        packed_.assign(balls, kNowhere);
        words_ = balls >= many ? (balls + kWordBits - 1) / kWordBits : 0;
        strips_.assign(2 * kStrips * words_, 0);
    }

    void set(std::size_t ball, const Box& box) {
        const std::uint64_t low = step(box.low_x, room_.low_x, per_metre_x_) |
                                  step(box.low_y, room_.low_y, per_metre_y_) << kBits;
        const std::uint64_t high = step(box.high_x, room_.low_x, per_metre_x_) |
                                   step(box.high_y, room_.low_y, per_metre_y_) << kBits;
        put(ball, low | ((kNowhere >> (2 * kBits)) - high) << (2 * kBits));
    }

    /// The ball has no box.
    void remove(std::size_t ball) { put(ball, kNowhere); }

    /// Calls meet(other) for every ball from `from` on whose box overlaps that of `ball`, in order.
    template <class Meet>
    void for_each_overlap(std::size_t ball, std::size_t from, Meet meet) const {
        for (std::size_t begin = from - from % kWordBits; begin < packed_.size();
             begin += kWordBits) {
            std::uint64_t near = strips_.empty() ? look_through(ball, begin) : sift(ball, begin);
            if (from > begin) near &= ~std::uint64_t{0} << (from - begin);
            for (; near != 0; near &= near - 1) {
                const std::size_t other = begin + static_cast<std::size_t>(std::countr_zero(near));
                if (other != ball) meet(other);
            }
        }
    }

  private:
    static constexpr int kBits = 16;  ///< of a field
    static constexpr std::uint64_t kSpare = 0x8000'8000'8000'8000;
    static constexpr std::uint64_t kNowhere = 0x7FFF'7FFF'7FFF'7FFF;  ///< above the highest side
    static constexpr Real kSteps = 0x7FFE;
    static constexpr std::size_t kStrips = 32;  ///< columns; rows
    static constexpr std::size_t kWordBits = 64;

    /// 1 to 0x7FFE.
    static std::uint64_t step(Real side, Real origin, Real per_metre) {
        const Real steps = std::min(std::max(Real{1}, (side - origin) * per_metre), kSteps);
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(steps));
    }

    /// The highest low sides of what overlaps the box, with the spare bits set.
    static std::uint64_t highest_of(std::uint64_t packed) {
        return (kNowhere - std::rotl(packed, 2 * kBits)) | kSpare;
    }

    /// The columns and rows of a box, from the first to the last; rows are counted after columns.
    struct Strips {
        explicit Strips(std::uint64_t packed) {
            constexpr int kStripBits = 10;
            const std::uint64_t low = packed;
            const std::uint64_t high = highest_of(packed) & kNowhere;
            first_column = (low & 0x7FFF) >> kStripBits;
            last_column = (high & 0x7FFF) >> kStripBits;
            first_row = kStrips + ((low >> kBits & 0x7FFF) >> kStripBits);
            last_row = kStrips + ((high >> kBits & 0x7FFF) >> kStripBits);
        }

        std::size_t first_column, last_column, first_row, last_row;
    };

    /// Which of the 64 balls from `begin` on overlap the ball's box: a bit each.
    [[nodiscard]] std::uint64_t look_through(std::size_t ball, std::size_t begin) const {
        const std::uint64_t highest = highest_of(packed_[ball]);
        const std::size_t count = std::min(packed_.size() - begin, kWordBits);
        std::uint64_t bits = 0;
        for (std::size_t i = begin + count; i-- > begin;)
            bits = 2 * bits + (overlaps(highest, packed_[i]) ? 1 : 0);
        return bits;
    }

    /// The same by way of the strips.
    [[nodiscard]] std::uint64_t sift(std::size_t ball, std::size_t begin) const {
        const std::uint64_t highest = highest_of(packed_[ball]);
        const Strips strips(packed_[ball]);
        const std::size_t word = begin / kWordBits;
        std::uint64_t bits = united(strips.first_column, strips.last_column, word) &
                             united(strips.first_row, strips.last_row, word);
        for (std::uint64_t left = bits; left != 0; left &= left - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(left));
            if (!overlaps(highest, packed_[begin + i])) bits ^= std::uint64_t{1} << i;
        }
        return bits;
    }

    static bool overlaps(std::uint64_t highest, std::uint64_t packed) {
        return ((highest - packed) & kSpare) == kSpare;
    }

    [[nodiscard]] std::uint64_t united(std::size_t first, std::size_t last,
                                       std::size_t word) const {
        std::uint64_t bits = 0;
        for (std::size_t strip = first; strip <= last; ++strip)
            bits |= strips_[strip * words_ + word];
        return bits;
    }

    void put(std::size_t ball, std::uint64_t packed) {
        if (words_ > 0) {
            flip(ball, packed_[ball]);
            flip(ball, packed);
        }
        packed_[ball] = packed;
    }

    /// Puts the ball's bit where it is not, and takes it away where it is.
    void flip(std::size_t ball, std::uint64_t packed) {
        if (packed == kNowhere) return;
        const Strips strips(packed);
        const std::uint64_t bit = std::uint64_t{1} << (ball % kWordBits);
        std::uint64_t* const word = strips_.data() + ball / kWordBits;
        for (std::size_t strip = strips.first_column; strip <= strips.last_column; ++strip)
            word[strip * words_] ^= bit;
        for (std::size_t strip = strips.first_row; strip <= strips.last_row; ++strip)
            word[strip * words_] ^= bit;
    }

    Box room_;
    Real per_metre_x_ = 0;
    Real per_metre_y_ = 0;
    std::vector<std::uint64_t> packed_;
    std::size_t words_ = 0;              ///< of bits a strip; 0 where balls are few
    std::vector<std::uint64_t> strips_;  ///< the columns, then the rows
};

}  // namespace poolhall
