#pragma once

#include "client/play/client_match.hpp"
#include "client/play/playback.hpp"
#include "client/play/view_state.hpp"

#include <optional>
#include <vector>

namespace poolhall::client {

/// The match as of the moment that playback shows: a shot that still rolls on the screen has no
/// result yet, whatever is known already.
class ShownTable {
  public:
    ShownTable(const ClientMatch& match, const Playback& playback)
        : match_(match), playback_(playback) {}

    /// What playback passes.
    void pass(const Playback::Passed& passed);
    /// To be called after the match and the playback have moved on. True if the result of the game
    /// has come into sight by that, or has gone.
    bool refresh();

    /// None before the first word from the server.
    [[nodiscard]] const std::optional<protocol::TableState>& table() const {
        return at_rest() ? match_.info().table : held_;
    }

    [[nodiscard]] bool at_rest() const { return playback_.idle(); }

    /// The seat that may aim and shoot from here, now.
    [[nodiscard]] std::optional<Seat> acting_seat() const;
    [[nodiscard]] std::vector<BallView> balls() const;

    /// Collision mode on or off.
    void toggle_collision_marks() { collision_mode_ = !collision_mode_; }

    [[nodiscard]] bool collision_mode() const { return collision_mode_; }

    /// Where balls have met in the shot that is shown, or was shown last; none out of collision
    /// mode.
    [[nodiscard]] std::vector<CollisionMark> collision_marks() const;
    /// A shot is shown, and the cue ball has gone down in it.
    [[nodiscard]] bool cue_ball_is_down() const;
    /// How the game ended, once that can be seen.
    [[nodiscard]] std::optional<Ruling> result() const;

  private:
    void hold_back();

    const ClientMatch& match_;
    const Playback& playback_;
    std::optional<protocol::TableState> held_;  ///< from before the shot that is shown
    std::optional<Shot> finished_;  ///< the last shot, once it has been shown, until the next
    bool has_result_ = false;
    bool collision_mode_ = false;
};

}  // namespace poolhall::client
