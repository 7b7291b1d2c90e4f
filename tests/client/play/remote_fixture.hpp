#pragma once

#include "client/play/cue_ball.hpp"
#include "client/play/remote_match.hpp"
#include "protocol/limits.hpp"
#include "tests/client/play/fixtures.hpp"

#include <gtest/gtest.h>
#include <memory>

namespace poolhall::client {

/// A client in a match on a server that the test plays.
class RemoteMatchTest : public ::testing::Test {
  protected:
    void open(EntryRequest wanted) {
        match_ = std::make_unique<RemoteMatch>(std::move(wanted), transport_, tokens_, playback_);
        transport_.events.emplace_back(Opened{});
        transport_.say(protocol::Welcome{"poolhall 0.1.0", protocol::kVersion});
        poll();
    }

    void open_as_anna() {
        open({"h:1", "", "Anna", false});
        joined({Seat{0}});
    }

    void joined(std::vector<Seat> seats, const protocol::TableState& table = new_table()) {
        transport_.say(
            protocol::Joined{last_seq(), seats.empty() ? "" : "t1", std::move(seats), table});
        poll();
        transport_.sent.clear();
    }

    void poll() { match_->poll(now_); }

    void pass(double seconds) {
        now_ += seconds;
        poll();
    }

    [[nodiscard]] std::uint32_t last_seq() const { return transport_.sent.back().seq; }

    template <class T>
    [[nodiscard]] std::vector<T> entries() const {
        return transport_.sent_of<T, protocol::EntryCommand>();
    }

    template <class T>
    [[nodiscard]] std::vector<T> seat_commands() const {
        return transport_.sent_of<T, protocol::SeatCommand>();
    }

    [[nodiscard]] std::vector<protocol::Aim> aims() const {
        return transport_.sent_of<protocol::Aim, protocol::TableTalk>();
    }

    [[nodiscard]] Vec2 cue() const { return cue_ball_of(*match_->info().table); }

    void shoot(Vec2 direction) { match_->make(Shoot{{.direction = direction}}); }

    TokensInMemory tokens_;
    ScriptedTransport transport_;
    Playback playback_{Pacing::kLive};
    std::unique_ptr<RemoteMatch> match_;
    double now_ = 100;
};

}  // namespace poolhall::client
