#pragma once

#include "client/play/match.hpp"
#include "client/play/playback.hpp"
#include "shared/game/settings.hpp"

namespace poolhall::client {

/// The original game, alone and offline: one player at the table, wins and losses counted against
/// the house.
class PracticeMatch : public Match {
  public:
    /// The settings must have passed the rules' check().
    PracticeMatch(const Ruleset& rules, std::string player, Playback& playback,
                  GameSettings settings = {});

    [[nodiscard]] const MatchInfo& info() const override { return info_; }

    void poll(double now) override;
    [[nodiscard]] double due_in(double now) const override;
    [[nodiscard]] std::string take_notice() override;

    void aim(Vec2 direction) override;
    void place_cue_ball(Vec2 position) override;
    void shoot(Vec2 direction) override;
    void ask_new_game() override;
    void toggle_hot_seat() override;
    void retry_now() override;

  private:
    static constexpr Seat kPlayer{0};
    static constexpr Seat kHouse{1};

    void show_state();

    const Ruleset& rules_;
    const GameSettings settings_;
    Playback& playback_;
    GameState state_;
    MatchInfo info_;
    std::string notice_;
};

}  // namespace poolhall::client
