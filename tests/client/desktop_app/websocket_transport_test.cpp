#include "client/desktop/net/websocket_transport.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/streambuf.hpp>
#include <boost/asio/write.hpp>

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace poolhall::client {
namespace {

using boost::asio::ip::tcp;
using namespace std::chrono_literals;

/// A port of this machine; it listens as long as the object lives.
class Port {
  public:
    [[nodiscard]] ServerAddress address() const {
        return {"127.0.0.1", std::to_string(acceptor_.local_endpoint().port())};
    }

    /// Accepts one connection and gives it this answer whatever it asks.
    void answer(const std::string& text) {
        tcp::socket socket = acceptor_.accept();
        boost::asio::streambuf request;
        boost::asio::read_until(socket, request, "\r\n\r\n");
        boost::asio::write(socket, boost::asio::buffer(text));
    }

  private:
    boost::asio::io_context context_;
    tcp::acceptor acceptor_{context_, {boost::asio::ip::make_address("127.0.0.1"), 0}};
};

std::optional<TransportEvent> await_event(Transport& transport) {
    const auto until = std::chrono::steady_clock::now() + 20s;
    while (std::chrono::steady_clock::now() < until) {
        if (auto event = transport.next()) return event;
        std::this_thread::sleep_for(5ms);
    }
    return std::nullopt;
}

WebSocketTransport transport_to(const ServerAddress& address) {
    return {address, protocol::Encoding::kJson, [] {}};
}

TEST(WebSocketTransport, NobodyListensIsSaidAndTriedAgain) {
    const ServerAddress nobody = Port().address();
    auto transport = transport_to(nobody);
    for (int attempt = 0; attempt < 3; ++attempt) {
        const auto event = await_event(transport);
        ASSERT_TRUE(event && std::holds_alternative<Lost>(*event));
        EXPECT_EQ(std::get<Lost>(*event).reason, "No server listens there");
        EXPECT_GT(std::get<Lost>(*event).retry_in, 0.1);
        transport.retry_now();
    }
}

TEST(WebSocketTransport, OtherKindOfServerIsSaid) {
    Port port;
    auto transport = transport_to(port.address());
    port.answer("HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n");
    const auto event = await_event(transport);
    ASSERT_TRUE(event && std::holds_alternative<Lost>(*event));
    EXPECT_EQ(std::get<Lost>(*event).reason, "The server refused the connection");
}

TEST(WebSocketTransport, NoiseInsteadOfAnAnswerIsSurvived) {
    Port port;
    auto transport = transport_to(port.address());
    port.answer(std::string(5000, '\xff') + "\r\n\r\n");
    const auto event = await_event(transport);
    ASSERT_TRUE(event && std::holds_alternative<Lost>(*event));
    EXPECT_FALSE(std::get<Lost>(*event).reason.empty());
}

TEST(WebSocketTransport, EndsAtOnceWhateverItIsDoing) {
    Port silent;
    const auto begin = std::chrono::steady_clock::now();
    {
        auto waiting_for_an_answer = transport_to(silent.address());
        auto between_attempts = transport_to(Port().address());
        std::this_thread::sleep_for(100ms);
        between_attempts.send({1, protocol::Ping{}});
        between_attempts.drop("no reason");
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
}

}  // namespace
}  // namespace poolhall::client
