#pragma once

#include "client/play/entrance.hpp"
#include "client/play/match.hpp"
#include "client/play/playback.hpp"
#include "client/play/transport.hpp"

#include <deque>
#include <string>

namespace poolhall::client {

/// A match on a server. Its own moves of aim and cue ball show at once; everything else is as the
/// server says.
class RemoteMatch : public Match {
  public:
    RemoteMatch(Wish wish, Transport& transport, TokenStore& tokens, Playback& playback);

    static constexpr double kPingEvery = 2;  ///< s
    static constexpr double kMoveEvery =
        1.0 / 30;  ///< s between two messages of a moving aim or cue ball

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
    void on(const Opened& event);
    void on(const Lost& event);
    void on(const Received& event);

    void on(const protocol::Welcome& message);
    void on(const protocol::Accepted& message);
    void on(const protocol::Reject& message);
    void on(const protocol::Joined& message);
    void on(const protocol::TableChanged& message);
    void on(const protocol::AimChanged& message);
    void on(const protocol::ShotStarted& message);
    void on(const protocol::Frame& message);
    void on(const protocol::ShotEnded& message);
    void on(const protocol::Pong& message);
    void on(const protocol::Closing& message);

    std::uint32_t send(protocol::ClientBody body);
    /// Like send, and remembers the command until it is answered.
    void command(protocol::ClientBody body);
    [[nodiscard]] std::optional<protocol::ClientBody> take_command(std::uint32_t seq);
    void enter(protocol::ClientBody request);
    void entry_refused(const protocol::Reject& reject);
    void send_moves();
    void ping_if_due();

    void show_table(const protocol::TableState& table);
    void note_changes(const protocol::TableState& before);
    void resume_playback(const protocol::TableState& table);
    [[nodiscard]] bool placing() const;
    void set_cue_ball(Vec2 position);

    struct Command {
        std::uint32_t seq = 0;
        protocol::ClientBody body;
    };

    Entrance entrance_;
    Transport& transport_;
    Playback& playback_;
    MatchInfo info_;
    std::string notice_;
    double now_ = 0;
    double received_at_ = 0;  ///< when the message in hand was read

    Seat second_seat_{1};  ///< the one that is given back when one person holds both

    std::uint32_t seq_ = 0;
    std::uint32_t entry_seq_ = 0;  ///< of the request to get in, while it is unanswered
    std::deque<Command> unanswered_;
    std::optional<Vec2> unsent_aim_;
    std::optional<Vec2> unsent_place_;
    double moved_at_ = 0;
    Vec2 confirmed_cue_;  ///< where the server last said the cue ball is, m
    std::uint32_t ping_seq_ = 0;
    double pinged_at_ = 0;
    std::string closing_reason_;
};

/// A join code as people read it aloud: "BCD-FGH".
[[nodiscard]] std::string shown_code(const std::string& code);

}  // namespace poolhall::client
