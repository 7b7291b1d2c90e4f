#include "tests/server/support/client.hpp"

#include <boost/asio/buffer.hpp>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <stdexcept>
#include <thread>

namespace poolhall::server::test {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using net::ip::tcp;
using Error = boost::system::error_code;

namespace {

constexpr auto kLimit = std::chrono::seconds(10);

tcp::endpoint endpoint_of(const std::string& address) {
    const auto colon = address.rfind(':');
    return {net::ip::make_address(address.substr(0, colon)),
            static_cast<std::uint16_t>(std::stoi(address.substr(colon + 1)))};
}

/// Starts an operation with a handler and runs the context until it is done.
template <class Start>
std::pair<Error, std::size_t> run(net::io_context& context, Start start) {
    std::optional<std::pair<Error, std::size_t>> result;
    start([&result](Error error, auto... size) {
        result.emplace(error, (std::size_t{0} + ... + size));
    });
    context.restart();
    const auto deadline = std::chrono::steady_clock::now() + kLimit;
    while (!result && context.run_one_until(deadline) > 0) {
    }
    if (!result) throw std::runtime_error("nothing happened for 10 s");
    return *result;
}

}  // namespace

struct Client::State {
    net::io_context context;
    websocket::stream<tcp::socket> stream{context};
    beast::flat_buffer buffer;
    protocol::Encoding encoding = protocol::Encoding::kJson;
    std::uint32_t seq = 0;
    std::string subprotocol;

    Error handshake(const ConnectSpec& spec, websocket::response_type& response) {
        tcp::socket& socket = stream.next_layer();
        socket.open(tcp::v4());
        if (spec.receive_buffer > 0)
            socket.set_option(net::socket_base::receive_buffer_size(spec.receive_buffer));
        socket.connect(endpoint_of(spec.address));
        stream.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
            if (spec.subprotocol)
                request.set(http::field::sec_websocket_protocol, *spec.subprotocol);
            if (spec.origin) request.set(http::field::origin, *spec.origin);
        }));
        return run(context,
                   [&](auto handler) {
                       stream.async_handshake(response, spec.address, spec.target, handler);
                   })
            .first;
    }
};

Client::Client(const ConnectSpec& spec) : state_(std::make_unique<State>()) {
    websocket::response_type response;
    if (const Error error = state_->handshake(spec, response))
        throw std::runtime_error("handshake: " + error.message());
    state_->stream.read_message_max(protocol::kMaxServerMessageBytes);
    state_->subprotocol = std::string(response[http::field::sec_websocket_protocol]);
    if (const auto encoding = protocol::encoding_of(state_->subprotocol))
        state_->encoding = *encoding;
}

Client::~Client() = default;
Client::Client(Client&&) noexcept = default;
Client& Client::operator=(Client&&) noexcept = default;

std::uint32_t Client::send(protocol::ClientBody body) {
    send(protocol::ClientMessage{++state_->seq, std::move(body)});
    return state_->seq;
}

void Client::send(const protocol::ClientMessage& message) {
    send_raw(encode(message, state_->encoding), state_->encoding == protocol::Encoding::kJson);
}

void Client::send_raw(std::string_view bytes, bool text) {
    state_->stream.text(text);
    const auto [error, size] = run(state_->context, [&](auto handler) {
        state_->stream.async_write(net::buffer(bytes.data(), bytes.size()), handler);
    });
    if (error) throw std::runtime_error("write: " + error.message());
}

std::variant<std::string, Closed> Client::receive_raw() {
    state_->buffer.clear();
    const auto [error, size] = run(
        state_->context, [&](auto handler) { state_->stream.async_read(state_->buffer, handler); });
    if (error)
        return Closed{error == websocket::error::closed ? state_->stream.reason().code
                                                        : std::uint16_t{0}};
    return beast::buffers_to_string(state_->buffer.data());
}

protocol::ServerMessage Client::receive() {
    const auto raw = receive_raw();
    const auto* bytes = std::get_if<std::string>(&raw);
    if (!bytes)
        throw std::runtime_error("closed with " + std::to_string(std::get<Closed>(raw).code));
    auto message = protocol::decode_server(*bytes, state_->encoding);
    if (!message) throw std::runtime_error("unreadable: " + message.error().reason);
    return std::move(*message);
}

std::optional<protocol::Reject> Client::answer(std::uint32_t seq) {
    for (;;) {
        const protocol::ServerMessage message = receive();
        if (const auto* reject = std::get_if<protocol::Reject>(&message);
            reject && reject->seq == seq)
            return *reject;
        if (const auto* accepted = std::get_if<protocol::Accepted>(&message);
            accepted && accepted->seq == seq)
            return std::nullopt;
        if (const auto* joined = std::get_if<protocol::Joined>(&message);
            joined && joined->seq == seq)
            return std::nullopt;
    }
}

Closed Client::wait_closed() {
    for (;;) {
        const auto raw = receive_raw();
        if (const auto* closed = std::get_if<Closed>(&raw)) return *closed;
    }
}

bool Client::readable(std::chrono::milliseconds limit) {
    const auto deadline = std::chrono::steady_clock::now() + limit;
    while (std::chrono::steady_clock::now() < deadline) {
        if (state_->stream.next_layer().available() > 0) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

void Client::close() {
    run(state_->context,
        [&](auto handler) { state_->stream.async_close(websocket::close_code::normal, handler); });
}

void Client::drop() {
    state_->stream.next_layer().close();
}

const std::string& Client::subprotocol() const {
    return state_->subprotocol;
}

HttpAnswer http_get(const std::string& address, const std::string& target,
                    const std::string& method) {
    net::io_context context;
    tcp::socket socket(context);
    socket.connect(endpoint_of(address));
    http::request<http::empty_body> request;
    request.method_string(method);
    request.target(target);
    request.version(11);
    request.set(http::field::host, address);
    http::write(socket, request);
    beast::flat_buffer buffer;
    http::response_parser<http::string_body> parser;
    parser.skip(method == "HEAD");
    const auto [error, size] =
        run(context, [&](auto handler) { http::async_read(socket, buffer, parser, handler); });
    if (error) throw std::runtime_error("http: " + error.message());
    const auto& response = parser.get();
    return {static_cast<int>(response.result_int()),
            std::string(response[http::field::content_type]), response.body()};
}

std::string exchange(const std::string& address, std::string_view bytes) {
    net::io_context context;
    tcp::socket socket(context);
    socket.connect(endpoint_of(address));
    Error broken;  // the server may have closed already
    net::write(socket, net::buffer(bytes.data(), bytes.size()), broken);
    std::string answer;
    run(context,
        [&](auto handler) { net::async_read(socket, net::dynamic_buffer(answer), handler); });
    return answer;
}

struct SilentConnections::State {
    net::io_context context;
    std::vector<tcp::socket> sockets;
};

SilentConnections::SilentConnections(const std::string& address, int count)
    : state_(std::make_unique<State>()) {
    for (int i = 0; i < count; ++i)
        state_->sockets.emplace_back(state_->context).connect(endpoint_of(address));
}

SilentConnections::~SilentConnections() = default;

HttpAnswer refused_handshake(const ConnectSpec& spec) {
    net::io_context context;
    websocket::stream<tcp::socket> stream(context);
    stream.next_layer().connect(endpoint_of(spec.address));
    stream.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
        if (spec.subprotocol) request.set(http::field::sec_websocket_protocol, *spec.subprotocol);
        if (spec.origin) request.set(http::field::origin, *spec.origin);
    }));
    websocket::response_type response;
    const auto [error, size] = run(context, [&](auto handler) {
        stream.async_handshake(response, spec.address, spec.target, handler);
    });
    if (!error) throw std::runtime_error("the handshake was accepted");
    return {static_cast<int>(response.result_int()),
            std::string(response[http::field::content_type]), response.body()};
}

}  // namespace poolhall::server::test
