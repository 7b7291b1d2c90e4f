#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

// WebSocket and HTTP as a client on this machine uses them. One event loop serves all sockets of
// the test: whoever waits for one of them also reads the others, so that no client is slow by
// accident.
namespace poolhall::e2e {

using Clock = std::chrono::steady_clock;

/// A message, and when it came.
struct Arrival {
    std::string bytes;
    bool text = false;
    Clock::time_point at;
};

/// How the server ended a connection.
struct Ending {
    std::uint16_t code = 0;  ///< of the close frame; 0 if there was none
    std::string reason;
};

class WebSocket {
  public:
    /// Connects to /ws. Throws std::runtime_error with the HTTP status if the handshake is refused.
    WebSocket(std::uint16_t port, std::string_view subprotocol);
    /// Drops the connection without a word, as a failing network does.
    ~WebSocket();
    WebSocket(WebSocket&& other) noexcept;
    WebSocket& operator=(WebSocket&& other) noexcept;
    WebSocket(const WebSocket&) = delete;
    WebSocket& operator=(const WebSocket&) = delete;

    /// Sends one message. A connection that the server has closed swallows it.
    void send(std::string_view bytes, bool text);
    /// Writes bytes to the TCP stream, past the WebSocket layer.
    void send_raw(std::string_view bytes);
    /// The next message, or nothing if the connection has ended. Throws std::runtime_error after
    /// `patience`.
    [[nodiscard]] std::optional<Arrival> receive(std::chrono::milliseconds patience);
    /// Waits for the end of the connection; messages before it are dropped.
    [[nodiscard]] Ending await_end(std::chrono::milliseconds patience);

  private:
    struct State;
    std::shared_ptr<State> state_;
};

/// The HTTP status that a WebSocket handshake gets; an empty subprotocol sends none.
[[nodiscard]] int handshake_status(std::uint16_t port, std::string_view subprotocol);

struct HttpAnswer {
    int status = 0;
    std::string content_type;
    std::string body;
};

/// GET. `target` goes out as it is.
[[nodiscard]] HttpAnswer http_get(std::uint16_t port, std::string_view target);

}  // namespace poolhall::e2e
