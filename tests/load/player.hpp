#pragma once

#include "protocol/codec/codec.hpp"

#include <boost/asio/io_context.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace poolhall::load {

/// What came over the wire, without WebSocket headers.
struct Traffic {
    std::uint64_t messages = 0;
    std::uint64_t bytes = 0;
};

/// A client that enters a match and, if it holds a seat, plays: it shoots when it is its turn, and
/// votes for another game when one is over. All clients of a context run on one thread.
class Player {
  public:
    /// Connects; throws if it cannot. `first` is the command by which it enters a match.
    Player(boost::asio::io_context& context, std::uint16_t port, protocol::Encoding encoding);
    ~Player();
    Player(Player&&) noexcept;
    Player& operator=(Player&&) noexcept;
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    void send(protocol::ClientBody body);
    /// Whether it shoots when it is its turn.
    void set_playing(bool playing);

    /// The code of the match that it is in; empty until it is.
    [[nodiscard]] const std::string& code() const;
    /// Messages that it has got, of every kind.
    [[nodiscard]] std::uint64_t messages() const;
    /// Shots that it has seen to their end, and all that came for them, shot_started to shot_ended.
    [[nodiscard]] std::uint64_t shots() const;
    [[nodiscard]] const Traffic& shot_traffic() const;

  private:
    struct State;
    std::shared_ptr<State> state_;
};

}  // namespace poolhall::load
