#include "client/desktop/net/websocket_transport.hpp"

#include "client/desktop/net/backoff.hpp"
#include "client/desktop/net/clock.hpp"
#include "protocol/limits.hpp"

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/connect.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>

#include <deque>
#include <mutex>
#include <random>
#include <thread>

namespace poolhall::client {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using namespace std::chrono_literals;

using Stream = websocket::stream<beast::tcp_stream>;

constexpr auto kConnectTime = 10s;
constexpr auto kIdleTime =
    8s;  // silence after which a connection counts as dead; half of it brings a ping
constexpr auto kCloseTime = 500ms;
constexpr std::size_t kMaxInbound = 4096;
constexpr std::size_t kMaxOutbound = 256;

constexpr auto kNoThrow = asio::as_tuple(asio::use_awaitable);

std::string_view subprotocol(protocol::Encoding encoding) {
    return encoding == protocol::Encoding::kCbor ? protocol::kSubprotocolCbor
                                                 : protocol::kSubprotocolJson;
}

std::string reason_of(const beast::error_code& error) {
    if (error == websocket::error::upgrade_declined) return "The server refused the connection";
    if (error == websocket::error::closed || error == asio::error::eof)
        return "The server closed the connection";
    if (error == beast::error::timeout) return "The server does not answer";
    if (error == asio::error::connection_refused) return "No server listens there";
    return error.message();
}

}  // namespace

/// All of it but start, stop and the two queues' ends runs on the thread.
class WebSocketTransport::Worker {
  public:
    Worker(ServerAddress server, protocol::Encoding encoding, std::function<void()> wake)
        : server_(std::move(server)),
          encoding_(encoding),
          wake_(std::move(wake)),
          thread_([this] { run(); }) {}

    // Only for want of memory can asking the thread to end fail, and nothing else would end it.
    // NOLINTNEXTLINE(bugprone-exception-escape)
    ~Worker() {
        asio::post(context_, [this] { stop(); });
        thread_.join();
    }

    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    std::optional<TransportEvent> next() {
        const std::lock_guard lock(mutex_);
        if (inbound_.empty()) return std::nullopt;
        TransportEvent event = std::move(inbound_.front());
        inbound_.pop_front();
        return event;
    }

    template <class Task>
    void post(Task task) {
        asio::post(context_, std::move(task));
    }

    void send(const protocol::ClientMessage& message) {
        if (!stream_ || !open_) return;
        if (outbound_.size() == kMaxOutbound) {
            drop("The server takes no messages");
            return;
        }
        outbound_.push_back(protocol::encode(message, encoding_));
        to_write_.cancel();
    }

    void drop(std::string reason) {
        if (!stream_) return;
        drop_reason_ = std::move(reason);
        beast::get_lowest_layer(*stream_).close();
    }

    void retry_now() { pause_.cancel(); }

  private:
    void run() {
        asio::co_spawn(context_, connect_for_ever(), asio::detached);
        context_.run();
    }

    void stop() {
        stopping_ = true;
        pause_.cancel();
        to_write_.cancel();
        if (stream_ && open_) {
            asio::co_spawn(context_, close_politely(), asio::detached);
        } else {
            context_.stop();
        }
    }

    asio::awaitable<void> close_politely() {
        pause_.expires_after(kCloseTime);
        pause_.async_wait([this](beast::error_code) { context_.stop(); });
        co_await stream_->async_close(websocket::close_code::going_away, kNoThrow);
        context_.stop();
    }

    asio::awaitable<void> connect_for_ever() {
        Backoff backoff(std::random_device{}());
        while (!stopping_) {
            bool heard = false;
            std::string reason = co_await connection(heard);
            if (stopping_) co_return;
            if (heard) backoff.reset();
            const auto pause = backoff.next();
            push(Lost{std::move(reason), std::chrono::duration<double>(pause).count()});
            pause_.expires_after(pause);
            co_await pause_.async_wait(kNoThrow);
        }
    }

    /// One connection from its beginning to its end; the reason why it ended. `heard`: the server
    /// said something.
    asio::awaitable<std::string> connection(bool& heard) {
        stream_.emplace(context_);
        drop_reason_.clear();
        outbound_.clear();
        beast::error_code error = co_await open();
        if (!error) {
            open_ = true;
            push(Opened{});
            asio::co_spawn(context_, write_all(), asio::detached);
            error = co_await read_all(heard);
            open_ = false;
            co_await finish_writing();
        }
        std::string reason = drop_reason_.empty() ? reason_of(error) : drop_reason_;
        // The closing handshake of a stop still uses the stream.
        if (!stopping_) stream_.reset();
        co_return reason;
    }

    asio::awaitable<beast::error_code> open() {
        tcp::resolver resolver(context_);
        auto [resolve_error, endpoints] =
            co_await resolver.async_resolve(server_.host, server_.port, kNoThrow);
        if (resolve_error) co_return resolve_error;
        auto& socket = beast::get_lowest_layer(*stream_);
        socket.expires_after(kConnectTime);
        auto [connect_error, endpoint] = co_await socket.async_connect(endpoints, kNoThrow);
        if (connect_error) co_return connect_error;
        beast::error_code
            ignored;  // without it, aiming is only a little less smooth for the others
        socket.socket().set_option(tcp::no_delay(true), ignored);
        socket.expires_never();
        co_return co_await shake_hands();
    }

    asio::awaitable<beast::error_code> shake_hands() {
        stream_->set_option(websocket::stream_base::timeout{kConnectTime, kIdleTime, true});
        stream_->set_option(
            websocket::stream_base::decorator([this](websocket::request_type& request) {
                const auto name = subprotocol(encoding_);
                request.set(beast::http::field::sec_websocket_protocol,
                            beast::string_view(name.data(), name.size()));
            }));
        stream_->read_message_max(protocol::kMaxServerMessageBytes);
        stream_->binary(encoding_ == protocol::Encoding::kCbor);
        websocket::response_type response;
        auto [error] = co_await stream_->async_handshake(response, to_string(server_),
                                                         std::string(protocol::kPath), kNoThrow);
        if (error) co_return error;
        const auto chosen = response[beast::http::field::sec_websocket_protocol];
        if (std::string_view(chosen.data(), chosen.size()) == subprotocol(encoding_))
            co_return error;
        drop_reason_ = "The server does not speak " + std::string(subprotocol(encoding_));
        co_return websocket::error::upgrade_declined;
    }

    asio::awaitable<beast::error_code> read_all(bool& heard) {
        beast::flat_buffer buffer;
        for (;;) {
            const auto [error, size] = co_await stream_->async_read(buffer, kNoThrow);
            if (error) co_return error;
            const auto bytes = buffer.data();
            const std::string_view text(static_cast<const char*>(bytes.data()), bytes.size());
            auto message = protocol::decode_server(text, encoding_);
            if (!message.ok()) {
                drop("The server sent what is no message: " + message.error().reason);
                co_return beast::error_code();
            }
            heard = true;
            if (!push(Received{std::move(message.value()), clock_now()})) {
                drop("This program could not keep up");
                co_return beast::error_code();
            }
            buffer.consume(buffer.size());
        }
    }

    asio::awaitable<void> write_all() {
        writing_ = true;
        while (open_) {
            if (outbound_.empty()) {
                to_write_.expires_at(asio::steady_timer::time_point::max());
                co_await to_write_.async_wait(kNoThrow);
                continue;
            }
            const std::string message = std::move(outbound_.front());
            outbound_.pop_front();
            const auto [error, size] =
                co_await stream_->async_write(asio::buffer(message), kNoThrow);
            // The reader meets the same end, and says so.
            if (error) break;
        }
        writing_ = false;
        written_.cancel();
    }

    /// The stream must outlive the writer.
    asio::awaitable<void> finish_writing() {
        to_write_.cancel();
        beast::get_lowest_layer(*stream_).close();
        while (writing_ && !stopping_) {
            written_.expires_at(asio::steady_timer::time_point::max());
            co_await written_.async_wait(kNoThrow);
        }
    }

    /// False when too much waits already. What happened to the connection itself is always told.
    bool push(TransportEvent event) {
        bool wake = false;
        {
            const std::lock_guard lock(mutex_);
            const bool message = std::holds_alternative<Received>(event);
            if (message && inbound_.size() >= kMaxInbound) return false;
            // A new connection makes the messages of the old one worthless.
            if (!message && inbound_.size() >= kMaxInbound) inbound_.clear();
            wake = inbound_.empty();
            inbound_.push_back(std::move(event));
        }
        if (wake) wake_();
        return true;
    }

    const ServerAddress server_;
    const protocol::Encoding encoding_;
    const std::function<void()> wake_;

    std::mutex mutex_;
    std::deque<TransportEvent> inbound_;  ///< guarded by mutex_

    asio::io_context context_{1};
    asio::steady_timer pause_{context_};
    asio::steady_timer to_write_{context_};  ///< cancelled when there is something to write
    asio::steady_timer written_{context_};   ///< cancelled when the writer has ended
    std::optional<Stream> stream_;
    std::deque<std::string> outbound_;
    std::string drop_reason_;
    bool open_ = false;
    bool writing_ = false;
    bool stopping_ = false;

    std::thread thread_;  ///< last: it uses all of the above
};

WebSocketTransport::WebSocketTransport(ServerAddress server, protocol::Encoding encoding,
                                       std::function<void()> wake)
    : worker_(std::make_unique<Worker>(std::move(server), encoding, std::move(wake))) {}

WebSocketTransport::~WebSocketTransport() = default;

std::optional<TransportEvent> WebSocketTransport::next() {
    return worker_->next();
}

void WebSocketTransport::send(protocol::ClientMessage message) {
    worker_->post(
        [worker = worker_.get(), message = std::move(message)] { worker->send(message); });
}

void WebSocketTransport::drop(std::string reason) {
    worker_->post([worker = worker_.get(), reason = std::move(reason)] { worker->drop(reason); });
}

void WebSocketTransport::retry_now() {
    worker_->post([worker = worker_.get()] { worker->retry_now(); });
}

}  // namespace poolhall::client
