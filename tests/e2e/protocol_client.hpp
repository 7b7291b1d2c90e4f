#pragma once

#include "protocol/encoding.hpp"
#include "protocol/messages.hpp"
#include "tests/e2e/web.hpp"

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace poolhall::e2e {

/// A server message, and when it came.
struct Heard {
    protocol::ServerMessage message;
    Clock::time_point at;
};

/// Everything that was sent of one shot.
struct ShotHeard {
    protocol::ShotStarted started;
    std::vector<protocol::Frame> frames;
    std::vector<Clock::time_point> frame_times;
    protocol::ShotEnded ended;
};

/// A client of the real server, over the real codec.
class ProtocolClient {
  public:
    /// Far longer than a shot takes: it passes only when something is wrong.
    static constexpr std::chrono::seconds kPatience{30};

    /// Connects and takes the welcome.
    ProtocolClient(std::uint16_t port, protocol::Encoding encoding);

    /// Sends a command and returns its seq.
    std::uint32_t send(protocol::ClientBody body);
    /// Sends a command with a seq of the test's choice.
    void send_as(std::uint32_t seq, protocol::ClientBody body);
    /// Sends a command and awaits its `accepted`; throws if it is rejected.
    void request(protocol::ClientBody body);
    /// create_match, join_match, watch_match or resume, and its answer.
    protocol::Joined enter(protocol::ClientBody body);
    /// Sends a command that must be rejected, and returns why.
    protocol::Reject refused(protocol::ClientBody body);

    /// The next message. Throws std::runtime_error if none comes, or the connection has ended.
    Heard hear();

    /// Drops messages up to the next of type T that satisfies `wanted`, and returns it. A reject or
    /// a closing that was not asked for throws.
    template <class T>
    T await(const std::function<bool(const T&)>& wanted = [](const T&) { return true; }) {
        for (;;) {
            Heard heard = hear();
            if (T* found = std::get_if<T>(&heard.message)) {
                if (wanted(*found)) return std::move(*found);
            } else {
                throw_if_refused(heard.message);
            }
        }
    }

    /// Waits for a state of the table.
    protocol::TableState await_table(
        const std::function<bool(const protocol::TableState&)>& wanted);

    /// Hears the next shot from its start to its end.
    ShotHeard hear_shot();

    [[nodiscard]] WebSocket& socket() { return socket_; }

    [[nodiscard]] protocol::Encoding encoding() const { return encoding_; }

  private:
    static void throw_if_refused(const protocol::ServerMessage& message);

    protocol::Encoding encoding_;
    WebSocket socket_;
    std::uint32_t seq_ = 0;
};

}  // namespace poolhall::e2e
