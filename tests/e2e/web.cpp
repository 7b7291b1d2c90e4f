#include "tests/e2e/web.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <deque>
#include <stdexcept>
#include <utility>

namespace poolhall::e2e {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::system::error_code;
using tcp = asio::ip::tcp;

constexpr std::chrono::seconds kWritePatience{20};

asio::io_context& loop() {
    static asio::io_context context;
    return context;
}

/// Runs the loop until `done` or the time is up.
template <class Done>
bool run_until(std::chrono::milliseconds patience, Done done) {
    const auto end = Clock::now() + patience;
    while (!done() && Clock::now() < end) {
        loop().restart();
        loop().run_one_until(end);
    }
    return done();
}

tcp::endpoint on_this_machine(std::uint16_t port) {
    return {asio::ip::address_v4::loopback(), port};
}

std::string host(std::uint16_t port) {
    return "127.0.0.1:" + std::to_string(port);
}

using Stream = websocket::stream<tcp::socket>;

/// Connects and shakes hands; returns the HTTP status, 101 if all is well.
int shake_hands(Stream& stream, std::uint16_t port, std::string_view subprotocol) {
    stream.next_layer().connect(on_this_machine(port));
    stream.next_layer().set_option(tcp::no_delay(true));
    stream.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
        if (!subprotocol.empty())
            request.set(http::field::sec_websocket_protocol,
                        beast::string_view(subprotocol.data(), subprotocol.size()));
    }));
    websocket::response_type response;
    error_code error;
    stream.handshake(response, host(port), "/ws", error);
    return static_cast<int>(response.result_int());
}

}  // namespace

struct WebSocket::State : std::enable_shared_from_this<State> {
    Stream stream{loop()};
    beast::flat_buffer buffer;
    std::deque<Arrival> arrivals;
    std::optional<Ending> ending;

    void read_next() {
        stream.async_read(buffer, [self = shared_from_this()](error_code error, std::size_t) {
            self->take(error);
        });
    }

    void take(error_code error) {
        if (error) {
            const auto& reason = stream.reason();
            ending = Ending{reason.code, std::string(reason.reason.data(), reason.reason.size())};
            return;
        }
        arrivals.push_back(
            {beast::buffers_to_string(buffer.data()), stream.got_text(), Clock::now()});
        buffer.clear();
        read_next();
    }
};

WebSocket::WebSocket(std::uint16_t port, std::string_view subprotocol)
    : state_(std::make_shared<State>()) {
    const int status = shake_hands(state_->stream, port, subprotocol);
    if (status != 101)
        throw std::runtime_error("the handshake was answered with " + std::to_string(status));
    state_->stream.read_message_max(std::size_t{1} << 20U);
    state_->read_next();
}

WebSocket::~WebSocket() {
    error_code ignored;
    if (state_) state_->stream.next_layer().close(ignored);
}

WebSocket::WebSocket(WebSocket&& other) noexcept = default;

WebSocket& WebSocket::operator=(WebSocket&& other) noexcept {
    std::swap(state_, other.state_);  // the other closes what was ours
    return *this;
}

void WebSocket::send(std::string_view bytes, bool text) {
    state_->stream.text(text);
    bool written = false;
    state_->stream.async_write(asio::buffer(bytes),
                               [&](error_code, std::size_t) { written = true; });
    // The handler refers to this frame, so it has to run before we leave; closing makes it run.
    if (run_until(kWritePatience, [&] { return written; })) return;
    state_->stream.next_layer().close();
    run_until(kWritePatience, [&] { return written; });
    throw std::runtime_error("the server does not read");
}

void WebSocket::send_raw(std::string_view bytes) {
    error_code ignored;
    asio::write(state_->stream.next_layer(), asio::buffer(bytes), ignored);
}

std::optional<Arrival> WebSocket::receive(std::chrono::milliseconds patience) {
    State& state = *state_;
    if (!run_until(patience, [&] { return !state.arrivals.empty() || state.ending; }))
        throw std::runtime_error("no message came");
    if (state.arrivals.empty()) return std::nullopt;
    Arrival first = std::move(state.arrivals.front());
    state.arrivals.pop_front();
    return first;
}

Ending WebSocket::await_end(std::chrono::milliseconds patience) {
    State& state = *state_;
    if (!run_until(patience, [&] { return state.ending.has_value(); }))
        throw std::runtime_error("the connection was not ended");
    return *state.ending;
}

int handshake_status(std::uint16_t port, std::string_view subprotocol) {
    Stream stream{loop()};
    return shake_hands(stream, port, subprotocol);
}

HttpAnswer http_get(std::uint16_t port, std::string_view target) {
    tcp::socket socket{loop()};
    socket.connect(on_this_machine(port));
    http::request<http::empty_body> request{http::verb::get,
                                            beast::string_view(target.data(), target.size()), 11};
    request.set(http::field::host, host(port));
    request.set(http::field::connection, "close");
    http::write(socket, request);
    beast::flat_buffer buffer;
    http::response_parser<http::string_body> response;
    response.body_limit(std::uint64_t{64} << 20U);
    http::read(socket, buffer, response);
    return {static_cast<int>(response.get().result_int()),
            std::string(response.get()[http::field::content_type]), response.get().body()};
}

}  // namespace poolhall::e2e
