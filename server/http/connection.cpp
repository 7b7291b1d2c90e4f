#include "server/http/connection.hpp"

#include "server/base/identity.hpp"
#include "server/http/handshake.hpp"
#include "server/session/session.hpp"

#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <chrono>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

namespace poolhall::server {
namespace {

namespace http = boost::beast::http;

/// For a whole request to come, and for its answer to be taken.
constexpr auto kTimeout = std::chrono::seconds(10);
constexpr std::uint32_t kMaxHeaderBytes = 8 * 1024;
constexpr std::uint64_t kMaxBodyBytes = 1024;  // nothing here takes a body

std::string_view view(boost::beast::string_view text) {
    return {text.data(), text.size()};
}

/// A socket that is closed if an operation takes too long.
struct Wire {
    explicit Wire(net::Socket connected)
        : socket(std::move(connected)), timer(socket.get_executor()) {}

    static void arm(const std::shared_ptr<Wire>& wire) {
        wire->timer.expires_after(kTimeout);
        wire->timer.async_wait([weak = std::weak_ptr(wire)](net::error_code error) {
            const auto late = weak.lock();
            net::error_code ignored;  // it is given up either way
            // A timer that was set anew meanwhile is not late.
            if (!error && late && late->timer.expiry() <= std::chrono::steady_clock::now())
                late->socket.close(ignored);
        });
    }

    net::Socket socket;
    net::Timer timer;
    boost::beast::flat_buffer buffer{kMaxHeaderBytes + kMaxBodyBytes};
};

/// What a request that cannot be read is answered with; nothing if nobody is there to read it.
std::optional<HttpReply> explain(net::error_code error) {
    if (error == http::error::header_limit || error == http::error::buffer_overflow)
        return error_reply(431, "The request's header is too large.");
    if (error == http::error::body_limit)
        return error_reply(413, "The request's body is too large.");
    if (error == http::error::end_of_stream || error == http::error::partial_message)
        return std::nullopt;
    if (error.category() == http::make_error_code(http::error::bad_method).category())
        return error_reply(400, "The request is not HTTP: " + error.message() + ".");
    return std::nullopt;
}

/// Not a coroutine itself: g++ 12 destroys a closure twice that is made within a co_await.
net::Async<HttpReply> answer_elsewhere(const Route& route, Shard& shard,
                                       ConnectionServices& services) {
    return net::await_callback<HttpReply>([&shard, &services, work = route.answer](auto resume) {
        net::post(services.readers, [&loop = shard.loop(), resume, work] {
            loop.post([resume, reply = work()] { resume(reply); });
        });
    });
}

net::Async<HttpReply> answer(const Route& route, Shard& shard, ConnectionServices& services) {
    if (!route.blocking) co_return route.answer();
    co_return co_await answer_elsewhere(route, shard, services);
}

struct Answering {
    unsigned version = 11;
    bool keep_alive = false;
    bool head = false;  ///< the header alone
};

net::Async<bool> send(const std::shared_ptr<Wire>& wire, HttpReply reply, Answering how) {
    http::response<http::string_body> response(static_cast<http::status>(reply.status),
                                               how.version);
    response.set(http::field::server,
                 boost::beast::string_view(kServerName.data(), kServerName.size()));
    response.set(http::field::content_type, reply.type);
    response.set(http::field::cache_control, "no-store");
    response.set("X-Content-Type-Options", "nosniff");
    for (const auto& [name, value] : reply.headers)
        response.set(name, value);
    response.keep_alive(how.keep_alive);
    response.body() = std::move(reply.body);
    response.prepare_payload();
    http::response_serializer<http::string_body> serializer(response);
    Wire::arm(wire);
    if (how.head) {
        const auto [error, size] =
            co_await http::async_write_header(wire->socket, serializer, net::kAwait);
        co_return !error && how.keep_alive;
    }
    const auto [error, size] = co_await http::async_write(wire->socket, serializer, net::kAwait);
    co_return !error && how.keep_alive;
}

std::optional<std::string_view> header(const HttpRequest& request, http::field field) {
    const auto found = request.find(field);
    if (found == request.end()) return std::nullopt;
    return view(found->value());
}

std::variant<AcceptedHandshake, HttpReply> judge(const HttpRequest& request,
                                                 const ConnectionServices& services) {
    if (services.counters.sessions.load() >= services.max_sessions)
        return error_reply(503, "The server has as many sessions as it may have.");
    const Handshake handshake{
        view(request.target()), header(request, http::field::host).value_or(""),
        header(request, http::field::origin), header(request, http::field::sec_websocket_protocol)};
    return judge(handshake, services.allowed_origins);
}

/// Answers requests; the one that asks for a WebSocket and may is returned.
net::Async<std::optional<std::pair<HttpRequest, AcceptedHandshake>>> serve_http(
    std::shared_ptr<Wire> wire, Shard& shard, ConnectionServices& services) {
    for (bool open = true; open;) {
        http::request_parser<http::string_body> parser;
        parser.header_limit(kMaxHeaderBytes);
        parser.body_limit(kMaxBodyBytes);
        Wire::arm(wire);
        const auto [error, size] =
            co_await http::async_read(wire->socket, wire->buffer, parser, net::kAwait);
        if (error) {
            if (auto reply = explain(error)) co_await send(wire, std::move(*reply), {});
            co_return std::nullopt;
        }
        HttpRequest request = parser.release();
        const Answering how{request.version(), request.keep_alive(),
                            request.method() == http::verb::head};
        if (boost::beast::websocket::is_upgrade(request)) {
            auto verdict = judge(request, services);
            if (const auto* accepted = std::get_if<AcceptedHandshake>(&verdict))
                co_return std::pair(std::move(request), *accepted);
            open = co_await send(wire, std::move(std::get<HttpReply>(verdict)), how);
            continue;
        }
        const Route route =
            find_route(services.routes, view(request.method_string()), view(request.target()));
        HttpReply reply = co_await answer(route, shard, services);
        open = co_await send(wire, std::move(reply), how);
    }
    co_return std::nullopt;
}

/// Counts a connection for as long as it is served.
class Counted {
  public:
    explicit Counted(std::atomic<std::int64_t>& count) : count_(count) { ++count_; }

    ~Counted() { --count_; }

    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;
    Counted(Counted&&) = delete;
    Counted& operator=(Counted&&) = delete;

  private:
    std::atomic<std::int64_t>& count_;
};

}  // namespace

net::Async<void> serve_connection(net::Socket socket, Shard& shard, ConnectionServices& services) {
    const Counted counted(services.counters.connections);
    auto wire = std::make_shared<Wire>(std::move(socket));
    net::error_code ignored;  // without it answers are only slower, or the peer is gone already
    wire->socket.set_option(net::ip::tcp::no_delay(true), ignored);
    auto upgrade = co_await serve_http(wire, shard, services);
    wire->timer.cancel();
    if (!upgrade) {
        wire->socket.shutdown(net::socket_base::shutdown_send, ignored);
        co_return;
    }
    // A session may last for hours: what only the handshake needed goes now.
    net::Socket upgraded = std::move(wire->socket);
    wire.reset();
    auto [request, handshake] = *std::exchange(upgrade, std::nullopt);
    co_await run_session(std::move(upgraded), std::move(request), handshake, shard,
                         services.sessions);
}

}  // namespace poolhall::server
