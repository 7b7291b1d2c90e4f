#pragma once

#include "client/play/client_match.hpp"
#include "client/play/playback.hpp"
#include "shared/match/match.hpp"

namespace poolhall::client {

/// A match that is played here, offline: alone (Turns::kSolo), wins and losses counted against the
/// other seat, or by two people on one machine.
class LocalMatch : public ClientMatch {
  public:
    LocalMatch(const MatchSpec& spec, const PerSeat<std::string>& names, Playback& playback);

    [[nodiscard]] const MatchInfo& info() const override { return info_; }

    void poll(double now) override;
    [[nodiscard]] double due_in(double now) const override;
    [[nodiscard]] std::string take_notice() override;

    void aim(Vec2 direction) override;
    void hold_cue_ball(Vec2 position) override;
    void make(const Move& move) override;
    void toggle_hot_seat() override;
    void retry_now() override;

  private:
    void play(Seat seat, const Move& move);
    void take(MatchStep step);
    void show_position();
    void show_clock();
    [[nodiscard]] std::int64_t now_ms() const;

    Match core_;
    Playback& playback_;
    MatchInfo info_;
    std::string notice_;
    double now_ = 0;  ///< s
};

/// The original game, alone against the house, with physics that have passed the rules' check().
[[nodiscard]] MatchSpec practice_spec(const Ruleset& rules, const GameSettings& settings = {});

}  // namespace poolhall::client
