#pragma once

#include "server/app/server.hpp"
#include "shared/game/end_game.hpp"
#include "tests/server/support/client.hpp"
#include "tests/server/support/temp_folder.hpp"

#include <array>
#include <chrono>
#include <gtest/gtest.h>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

namespace poolhall::server::test {

/// A real server in this process, on a free port, with a store of its own.
class RunningServer {
  public:
    explicit RunningServer(ServerConfig config = {}) : config_(std::move(config)) { start(); }

    /// Ends the server and starts another on the same store.
    void restart() {
        server_.reset();
        start();
    }

    [[nodiscard]] Server& server() { return *server_; }

    [[nodiscard]] std::string address() const { return server_->address(); }

    [[nodiscard]] ConnectSpec json() const { return spec(protocol::kSubprotocolJson); }

    [[nodiscard]] ConnectSpec cbor() const { return spec(protocol::kSubprotocolCbor); }

    [[nodiscard]] const std::filesystem::path& data() const { return folder_.path(); }

  private:
    [[nodiscard]] ConnectSpec spec(std::string_view subprotocol) const {
        ConnectSpec spec;
        spec.address = address();
        spec.subprotocol = std::string(subprotocol);
        return spec;
    }

    void start() {
        config_.listen = "127.0.0.1:0";
        config_.data = folder_.str();
        config_.threads = 2;
        auto started = Server::start(config_);
        if (!started) throw std::runtime_error(started.error());
        server_ = std::move(*started);
    }

    TempFolder folder_;
    ServerConfig config_;
    std::unique_ptr<Server> server_;
};

/// Waits until something holds, at most 10 s.
template <class Condition>
[[nodiscard]] bool eventually(Condition condition) {
    for (int tries = 0; tries < 2000; ++tries) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

/// From the start: pots nothing, rolls out in about 6 s.
inline constexpr Vec2 kSafeDirection{-1, 0.02};
/// From the start: the cue ball goes down in the near corner after 0.2 s, and the game is over.
inline const Vec2 kScratchDirection{-end_game::kLength / 2 - end_game::kBaseLineX,
                                    end_game::kWidth / 2};

/// Makes the server tell everyone at the table far more than sockets hold. The player holds both
/// seats before and after.
inline void flood_table(Client& player) {
    for (int i = 0; i < 120; ++i) {
        if (player.ask(protocol::LeaveSeat{Seat{1}}) || player.ask(protocol::TakeSeat{Seat{1}}))
            throw std::runtime_error("the seat cannot be changed");
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

/// A shot as hard as the game has it.
[[nodiscard]] inline protocol::MakeMove shoot(Seat seat, Vec2 direction = kSafeDirection) {
    return {seat, Shoot{Stroke{direction, {}}}};
}

/// Two players at a table of a real server, in both encodings.
struct Table {
    explicit Table(const RunningServer& server)
        : players{Client(server.json()), Client(server.cbor())} {
        players[0].send(protocol::CreateMatch{"Ada"});
        joined[0] = players[0].expect<protocol::Joined>();
        players[1].send(protocol::JoinMatch{code(), "Ben"});
        joined[1] = players[1].expect<protocol::Joined>();
    }

    [[nodiscard]] const std::string& code() const { return joined[0].table.code; }

    /// The seat shoots, and everything of it is read by both players.
    protocol::ShotEnded play(Seat seat, Vec2 direction = kSafeDirection) {
        const auto refused = players[seat.value].ask(shoot(seat, direction));
        if (refused) throw std::runtime_error("refused: " + refused->reason);
        players[1 - seat.value].expect<protocol::ShotEnded>();
        return players[seat.value].expect<protocol::ShotEnded>();
    }

    std::array<Client, 2> players;
    std::array<protocol::Joined, 2> joined;
};

}  // namespace poolhall::server::test
