#pragma once

#include "protocol/codec/codec.hpp"
#include "protocol/limits.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace poolhall::server::test {

struct ConnectSpec {
    std::string address;  ///< ADDR:PORT
    std::string target = "/ws";
    std::optional<std::string> subprotocol = std::string(protocol::kSubprotocolJson);
    std::optional<std::string> origin;
    int receive_buffer = 0;  ///< of the socket, bytes; 0: the system's
};

/// The server has closed the connection.
struct Closed {
    std::uint16_t code = 0;  ///< WebSocket close code; 0: without a close frame
};

/// A WebSocket client on a real socket. Everything waits at most 10 s and throws std::runtime_error
/// then.
class Client {
  public:
    /// Throws if the handshake is refused.
    explicit Client(const ConnectSpec& spec);
    ~Client();
    Client(Client&&) noexcept;
    Client& operator=(Client&&) noexcept;
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    /// Sends a command with the next seq, which is returned.
    std::uint32_t send(protocol::ClientBody body);
    void send(const protocol::ClientMessage& message);
    void send_raw(std::string_view bytes, bool text);

    /// The next message as it came, or how the connection ended.
    std::variant<std::string, Closed> receive_raw();
    /// The next message; throws if the connection ended.
    protocol::ServerMessage receive();

    /// The next message of this type; those before it are thrown away.
    template <class T>
    T expect() {
        for (;;) {
            protocol::ServerMessage message = receive();
            if (auto* wanted = std::get_if<T>(&message)) return std::move(*wanted);
        }
    }

    /// What answers the command: nothing if it was accepted.
    std::optional<protocol::Reject> answer(std::uint32_t seq);

    std::optional<protocol::Reject> ask(protocol::ClientBody body) {
        return answer(send(std::move(body)));
    }

    /// Reads to the end and says how it came.
    Closed wait_closed();
    /// Whether a message comes within this time; it is not taken.
    bool readable(std::chrono::milliseconds limit);
    void close();
    /// Ends the connection without a close frame.
    void drop();

    /// The subprotocol that the server named; empty if none.
    [[nodiscard]] const std::string& subprotocol() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Status and body of a request; throws if there is no answer.
struct HttpAnswer {
    int status = 0;
    std::string type;
    std::string body;
};

HttpAnswer http_get(const std::string& address, const std::string& target,
                    const std::string& method = "GET");
/// Sends the bytes on a new connection and returns all that comes back until the server closes.
std::string exchange(const std::string& address, std::string_view bytes);

/// Connections that say nothing, for as long as it lives.
class SilentConnections {
  public:
    SilentConnections(const std::string& address, int count);
    ~SilentConnections();
    SilentConnections(const SilentConnections&) = delete;
    SilentConnections& operator=(const SilentConnections&) = delete;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// What a refused WebSocket handshake is answered with.
HttpAnswer refused_handshake(const ConnectSpec& spec);

}  // namespace poolhall::server::test
