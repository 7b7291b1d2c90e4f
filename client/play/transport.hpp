#pragma once

#include "protocol/messages.hpp"

#include <optional>
#include <string>
#include <variant>

namespace poolhall::client {

/// What comes up from a connection, in order.
struct Opened {};

struct Lost {
    std::string reason;   ///< one sentence without a full stop
    double retry_in = 0;  ///< s until the next attempt
};

struct Received {
    protocol::ServerMessage message;
    double at = 0;  ///< when it was read, s on the client's clock
};

using TransportEvent = std::variant<Opened, Lost, Received>;

/// A connection to a server that is made again whenever it breaks, for ever.
class Transport {
  public:
    Transport() = default;
    Transport(const Transport&) = delete;
    Transport& operator=(const Transport&) = delete;
    virtual ~Transport() = default;

    /// The next event, if one waits; never blocks.
    [[nodiscard]] virtual std::optional<TransportEvent> next() = 0;
    /// Sends when a connection is open, else drops it: after Lost nothing of before matters.
    virtual void send(protocol::ClientMessage message) = 0;
    /// Breaks the connection, with the reason that Lost will give.
    virtual void drop(std::string reason) = 0;
    /// Tries again at once rather than at the end of the pause.
    virtual void retry_now() = 0;
};

}  // namespace poolhall::client
