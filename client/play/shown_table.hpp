#pragma once

#include "client/play/match.hpp"
#include "client/play/playback.hpp"

#include <optional>
#include <vector>

namespace poolhall::client {

/// The match as of the moment that playback shows: a shot that still rolls on the screen has no
/// result yet, whatever is known already.
class ShownTable {
  public:
    ShownTable(const Match& match, const Playback& playback) : match_(match), playback_(playback) {}

    /// To be called after the match and the playback have moved on.
    void refresh();
    void shot_finished(const Shot& shot);

    /// None before the first word from the server.
    [[nodiscard]] const std::optional<protocol::TableState>& table() const {
        return at_rest() ? match_.info().table : held_;
    }

    [[nodiscard]] bool at_rest() const { return playback_.idle(); }

    /// The seat that may aim and shoot from here, now.
    [[nodiscard]] std::optional<Seat> acting_seat() const;
    [[nodiscard]] std::vector<BallView> balls() const;
    /// A shot is shown, and the cue ball has gone down in it.
    [[nodiscard]] bool scratched() const;
    /// How the game ended, once that can be seen.
    [[nodiscard]] std::optional<Ruling> result() const;

  private:
    const Match& match_;
    const Playback& playback_;
    std::optional<protocol::TableState> held_;  ///< from before the shot that is shown
    std::uint32_t finished_shot_ = 0;
    std::vector<BallView>
        after_shot_;  ///< the balls as shot `finished_shot_` left them, sunk ones too
};

}  // namespace poolhall::client
