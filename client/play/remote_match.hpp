#pragma once

#include "client/play/client_match.hpp"
#include "client/play/entrance.hpp"
#include "client/play/playback.hpp"
#include "client/play/sent_commands.hpp"
#include "client/play/transport.hpp"

#include <string>

namespace poolhall::client {

/// A match on a server. Where its own seats aim and hold the cue ball shows at once; everything
/// else is as the server says.
class RemoteMatch : public ClientMatch {
  public:
    RemoteMatch(EntryRequest wanted, Transport& transport, TokenKeeper& tokens, Playback& playback);

    static constexpr double kPingEvery = 2;        ///< s
    static constexpr double kAimEvery = 1.0 / 30;  ///< s between two messages of a moving aim

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

    /// Sends, and remembers the command until it is answered.
    void command(protocol::ClientBody body);
    void enter(protocol::ClientBody request);
    void entry_refused(const protocol::Reject& reject);
    void send_aim();
    void ping_if_due();

    void show_table(const protocol::TableState& table);
    void note_changes(const protocol::TableState& before);
    void note_time_out(const protocol::TableState& before);
    void resume_playback(const protocol::TableState& table);

    Entrance entrance_;
    Transport& transport_;
    Playback& playback_;
    MatchInfo info_;
    std::string notice_;
    double now_ = 0;
    double received_at_ = 0;  ///< when the message in hand was read

    Seat second_seat_{1};  ///< the one that is given back when one person holds both

    SentCommands sent_;
    std::uint32_t entry_seq_ = 0;  ///< of the request to get in, while it is unanswered
    bool aim_unsent_ = false;      ///< the others do not see yet where this client aims
    double aim_sent_at_ = 0;       ///< s
    std::uint32_t ping_seq_ = 0;
    double pinged_at_ = 0;
    std::string closing_reason_;
};

}  // namespace poolhall::client
