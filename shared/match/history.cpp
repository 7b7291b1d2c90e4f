#include "shared/match/history.hpp"

#include <algorithm>
#include <iterator>

namespace poolhall {

void MatchHistory::add(const MadeMove& made, const Position& after) {
    moves_.push_back(made);
    if (moves_.size() >= kept_.back().moves + kSpacing) keep(after);
}

void MatchHistory::keep(const Position& now) {
    if (kept_.back().moves == moves_.size()) kept_.pop_back();
    kept_.push_back({moves_.size(), now});
}

const MatchHistory::Kept& MatchHistory::last_kept(std::size_t moves) const {
    const auto after =
        std::upper_bound(kept_.begin(), kept_.end(), moves,
                         [](std::size_t count, const Kept& kept) { return count < kept.moves; });
    return *std::prev(after);
}

}  // namespace poolhall
