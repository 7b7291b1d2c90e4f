#pragma once

#include "shared/match/position.hpp"

#include <cstddef>
#include <vector>

namespace poolhall {

/// The moves of a match, and now and then the position between them: all others follow from those.
class MatchHistory {
  public:
    /// Moves from one kept position to the next: what a look back costs at most, against some 2 kB
    /// for each position that is kept.
    static constexpr std::size_t kSpacing = 16;

    /// Begins with the position before the first move.
    explicit MatchHistory(const Position& begin) : kept_{{0, begin}} {}

    [[nodiscard]] const std::vector<MadeMove>& moves() const { return moves_; }

    /// Adds a move that led to `after`.
    void add(const MadeMove& made, const Position& after);
    /// Keeps the position as it is now, which does not follow from the moves alone.
    void keep(const Position& now);

    struct Kept {
        std::size_t moves = 0;  ///< before it
        Position position;
    };

    /// The last kept position at or before that many moves.
    [[nodiscard]] const Kept& last_kept(std::size_t moves) const;

  private:
    std::vector<MadeMove> moves_;
    std::vector<Kept> kept_;  ///< rising
};

}  // namespace poolhall
