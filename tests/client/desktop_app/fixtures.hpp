#pragma once

#include "client/play/playback.hpp"
#include "client/play/transport.hpp"
#include "protocol/messages.hpp"
#include "shared/game/end_game.hpp"

#include <deque>
#include <filesystem>
#include <vector>

namespace poolhall::client {

/// The server's side of a connection, played by the test: it feeds events and keeps what was sent.
class ScriptedTransport : public Transport {
  public:
    std::optional<TransportEvent> next() override {
        if (events.empty()) return std::nullopt;
        TransportEvent event = std::move(events.front());
        events.pop_front();
        return event;
    }

    void send(protocol::ClientMessage message) override { sent.push_back(std::move(message)); }

    void drop(std::string reason) override { dropped = std::move(reason); }

    void retry_now() override { ++retries; }

    void say(protocol::ServerMessage message, double at = 0) {
        events.emplace_back(Received{std::move(message), at});
    }

    std::deque<TransportEvent> events;
    std::vector<protocol::ClientMessage> sent;
    std::string dropped;
    int retries = 0;
};

/// A folder that is gone after the test.
class TemporaryFolder {
  public:
    TemporaryFolder();

    ~TemporaryFolder() { std::filesystem::remove_all(path); }

    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path path;
};

/// A new end game between Anna (seat 0, to shoot) and Ben.
[[nodiscard]] protocol::TableState new_table();

/// The messages that a server sends for this shot from that table, from shot_started to shot_ended.
[[nodiscard]] std::vector<protocol::ServerMessage> messages_of_shot(
    const protocol::TableState& table, Vec2 direction);

/// Straight at the 8-ball from the middle of the base line: nothing goes down.
inline constexpr Vec2 kStraight{1, 0};

/// A direction from the middle of the base line with that end, found by trying; balls roll on for
/// at least `after` s once it is certain.
[[nodiscard]] Vec2 direction_with(Verdict verdict, double after = 0);

}  // namespace poolhall::client
