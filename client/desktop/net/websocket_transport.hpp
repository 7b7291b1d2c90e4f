#pragma once

#include "client/desktop/net/server_address.hpp"
#include "client/play/transport.hpp"
#include "protocol/codec/codec.hpp"

#include <functional>
#include <memory>

namespace poolhall::client {

/// The Transport over WebSocket, on a thread of its own. Both queues are bounded: a client that
/// cannot keep up with its server, or a server that takes nothing, costs the connection and never
/// the memory.
class WebSocketTransport : public Transport {
  public:
    /// `wake` is called on the transport's thread when there is something new for next().
    WebSocketTransport(ServerAddress server, protocol::Encoding encoding,
                       std::function<void()> wake);
    /// Closes politely, within half a second.
    ~WebSocketTransport() override;

    [[nodiscard]] std::optional<TransportEvent> next() override;
    void send(protocol::ClientMessage message) override;
    void drop(std::string reason) override;
    void retry_now() override;

  private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace poolhall::client
