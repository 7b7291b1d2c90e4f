#include "server/http/connection.hpp"

#include "server/base/identity.hpp"
#include "server/http/handshake.hpp"
#include "server/http/request_target.hpp"
#include "server/session/session.hpp"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <chrono>
#include <exception>
#include <memory>
#include <optional>
#include <spdlog/spdlog.h>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

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

    /// Closes it, from any thread, if it is there still.
    static std::function<void()> closer(const std::shared_ptr<Wire>& wire, Loop& loop) {
        return [weak = std::weak_ptr(wire), &loop] {
            loop.post([weak] {
                net::error_code ignored;  // it is given up either way
                if (const auto late = weak.lock()) late->socket.close(ignored);
            });
        };
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
net::Async<HttpReply> answer_elsewhere(const Route& route, Shard& shard, HttpServices& services) {
    return net::await_callback<HttpReply>([&shard, &services, work = route.answer](auto resume) {
        net::post(services.readers, [&loop = shard.loop(), resume, work] {
            loop.post([resume, reply = work()] { resume(reply); });
        });
    });
}

net::Async<HttpReply> answer(const Route& route, Shard& shard, HttpServices& services) {
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
                                                 const RequestTarget& target,
                                                 const HttpServices& services) {
    if (services.sessions.counters.sessions.load() >= services.max_sessions)
        return error_reply(503, "The server has as many sessions as it may have.");
    const Handshake handshake{target.path, target.host, header(request, http::field::origin),
                              header(request, http::field::sec_websocket_protocol)};
    return judge(handshake, services.allowed_origins);
}

/// A robust server ignores empty lines before a request: RFC 9112, section 2.2.
net::Async<bool> skip_empty_lines(const std::shared_ptr<Wire>& wire) {
    constexpr std::size_t kRead = 4096;
    for (;;) {
        const auto bytes = wire->buffer.data();
        const std::string_view begin(static_cast<const char*>(bytes.data()), bytes.size());
        if (begin.starts_with("\r\n")) {
            wire->buffer.consume(2);
        } else if (begin.empty() || begin == "\r") {
            const auto [error, size] =
                co_await wire->socket.async_read_some(wire->buffer.prepare(kRead), net::kAwait);
            if (error) co_return false;
            wire->buffer.commit(size);
        } else {
            co_return true;
        }
    }
}

/// The next request; nothing if none comes, or what came is none and has been answered.
net::Async<std::optional<HttpRequest>> read_request(const std::shared_ptr<Wire>& wire) {
    http::request_parser<http::string_body> parser;
    parser.header_limit(kMaxHeaderBytes);
    parser.body_limit(kMaxBodyBytes);
    Wire::arm(wire);
    if (!co_await skip_empty_lines(wire)) co_return std::nullopt;
    const auto [error, size] =
        co_await http::async_read(wire->socket, wire->buffer, parser, net::kAwait);
    if (!error) co_return parser.release();
    if (auto reply = explain(error)) co_await send(wire, std::move(*reply), {});
    co_return std::nullopt;
}

std::vector<std::string_view> hosts_of(const HttpRequest& request) {
    std::vector<std::string_view> hosts;
    const auto [first, last] = request.equal_range(http::field::host);
    for (auto field = first; field != last; ++field)
        hosts.push_back(view(field->value()));
    return hosts;
}

struct Upgrade {
    HttpRequest request;
    AcceptedHandshake handshake;
};

/// What a request is answered with, or how it becomes a session.
net::Async<std::variant<HttpReply, AcceptedHandshake>> respond(const HttpRequest& request,
                                                               const Admission::Place& place,
                                                               Shard& shard,
                                                               HttpServices& services) {
    const auto target = read_target(request.version(), view(request.target()), hosts_of(request));
    if (!target) co_return target.error();
    const bool upgrade = boost::beast::websocket::is_upgrade(request);
    if (place.is_reserved() && (upgrade || !is_health_check(target->path)))
        co_return error_reply(503, "The server has as many connections as it may have.");
    if (upgrade) {
        auto verdict = judge(request, *target, services);
        if (const auto* accepted = std::get_if<AcceptedHandshake>(&verdict)) co_return *accepted;
        co_return std::move(std::get<HttpReply>(verdict));
    }
    const Route route = find_route(services.routes, view(request.method_string()), target->path);
    co_return co_await answer(route, shard, services);
}

/// Answers requests; the one that asks for a WebSocket and may is returned.
net::Async<std::optional<Upgrade>> serve_http(std::shared_ptr<Wire> wire, Admission::Place& place,
                                              Shard& shard, HttpServices& services) {
    for (bool open = true; open;) {
        if (!place.wait(Wire::closer(wire, shard.loop()))) co_return std::nullopt;
        auto request = co_await read_request(wire);
        if (!request || !place.work()) co_return std::nullopt;
        const Answering how{request->version(), request->keep_alive() && !place.is_reserved(),
                            request->method() == http::verb::head};
        auto response = co_await respond(*request, place, shard, services);
        if (const auto* accepted = std::get_if<AcceptedHandshake>(&response))
            co_return Upgrade{std::move(*request), *accepted};
        open = co_await send(wire, std::move(std::get<HttpReply>(response)), how);
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

net::Async<void> run_connection(net::Socket socket, std::shared_ptr<Admission::Place> place,
                                Shard& shard, HttpServices& services) {
    const Counted counted(services.sessions.counters.connections);
    auto wire = std::make_shared<Wire>(std::move(socket));
    net::error_code ignored;  // without it answers are only slower, or the peer is gone already
    wire->socket.set_option(net::ip::tcp::no_delay(true), ignored);
    auto upgrade = co_await serve_http(wire, *place, shard, services);
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

void log_failure(const std::exception_ptr& thrown) {
    if (!thrown) return;
    try {
        std::rethrow_exception(thrown);
    } catch (const std::exception& error) {
        spdlog::error("a connection ended by an exception: {}", error.what());
    }
}

}  // namespace

void serve_connection(net::Socket socket, Shard& shard, HttpServices& services) {
    net::error_code gone;
    const auto peer = socket.remote_endpoint(gone);
    if (gone) return;
    auto place = services.admission.admit(peer.address());
    if (!place) return;
    net::co_spawn(shard.loop().context().get_executor(),
                  run_connection(std::move(socket), std::move(place), shard, services),
                  log_failure);
}

}  // namespace poolhall::server
