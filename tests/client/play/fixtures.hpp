#pragma once

#include "client/play/playback.hpp"
#include "client/play/token_keeper.hpp"
#include "client/play/transport.hpp"
#include "protocol/messages.hpp"
#include "shared/game/end_game.hpp"

#include <deque>
#include <vector>

namespace poolhall::client {

/// The server's side of a connection, played by the test: it feeds events and keeps what was sent.
class ScriptedTransport : public Transport {
  public:
    std::optional<TransportEvent> next() override;

    void send(protocol::ClientMessage message) override { sent.push_back(std::move(message)); }

    void drop(std::string reason) override { dropped = std::move(reason); }

    void retry_now() override { ++retries; }

    void say(protocol::ServerMessage message, double at = 0) {
        events.emplace_back(Received{std::move(message), at});
    }

    /// The commands of type T in that group that were sent.
    template <class T, class Group>
    [[nodiscard]] std::vector<T> sent_of() const {
        std::vector<T> found;
        for (const auto& message : sent) {
            const auto* group = std::get_if<Group>(&message.body);
            const T* body = group != nullptr ? std::get_if<T>(group) : nullptr;
            if (body != nullptr) found.push_back(*body);
        }
        return found;
    }

    /// The moves that were sent.
    [[nodiscard]] std::vector<Move> moves() const;
    /// How many of them were shots.
    [[nodiscard]] std::size_t shots() const;

    std::deque<TransportEvent> events;
    std::vector<protocol::ClientMessage> sent;
    std::string dropped;
    int retries = 0;
};

/// Tokens that last as long as the test.
class TokensInMemory : public TokenKeeper {
  public:
    std::optional<std::string> claim(std::string_view server, std::string_view code) override;
    void keep(std::string_view server, std::string_view code, std::string_view token) override;
    void forget(std::string_view token) override;

  private:
    struct Entry {
        std::string server;
        std::string code;
        std::string token;
    };

    std::vector<Entry> entries_;
};

/// What comes of a shot in that direction, by the rules of the end game.
[[nodiscard]] Turn turn_of(const GameState& state, Vec2 direction);

/// A new end game between Anna (seat 0, to shoot) and Ben.
[[nodiscard]] protocol::TableState new_table();

/// The same with the turn of that seat.
[[nodiscard]] protocol::TableState table_with_turn(Seat seat);

/// The messages that a server sends for this shot from that table, from shot_started to shot_ended.
[[nodiscard]] std::vector<protocol::ServerMessage> messages_of_shot(
    const protocol::TableState& table, Vec2 direction);

/// Straight at the 8-ball from the middle of the base line: nothing goes down.
inline constexpr Vec2 kStraight{1, 0};

/// A direction from the middle of the base line with that end, found by trying; balls roll on for
/// at least `after` s once it is certain.
[[nodiscard]] Vec2 direction_with(Verdict verdict, double after = 0);

}  // namespace poolhall::client
