#pragma once

#include "protocol/messages.hpp"
#include "shared/physics/scene/scene.hpp"

#include <cstdint>
#include <vector>

// Messages with random content that a correct peer could send.
namespace poolhall::protocol::testing {

/// Makes the same values on every machine from one seed (splitmix64).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    [[nodiscard]] std::uint64_t word();
    /// 0 to bound - 1.
    [[nodiscard]] std::size_t below(std::size_t bound);

    [[nodiscard]] bool coin() { return below(2) == 1; }

    /// Any double from -limit to limit.
    [[nodiscard]] double real(double limit);

  private:
    std::uint64_t state_;
};

/// A scene that check() accepts, with 1 to 6 balls.
[[nodiscard]] Scene random_scene(Random& random, bool with_strike);

/// A move of each kind, with every field or with those that may be left out left out.
[[nodiscard]] std::vector<Move> random_moves(Random& random);

/// One message of each kind, and of `move` one with each kind of move.
[[nodiscard]] std::vector<ClientMessage> random_client_messages(Random& random);
/// One message of each kind.
[[nodiscard]] std::vector<ServerMessage> random_server_messages(Random& random);

}  // namespace poolhall::protocol::testing
