#include "server/session/session.hpp"

#include "protocol/codec/codec.hpp"
#include "protocol/intake/decode_client.hpp"
#include "protocol/limits.hpp"
#include "server/base/identity.hpp"
#include "server/delivery/outbox.hpp"
#include "server/session/rate_credit.hpp"

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>

#include <chrono>
#include <exception>
#include <memory>
#include <optional>
#include <spdlog/spdlog.h>
#include <string_view>
#include <utility>
#include <variant>

namespace poolhall::server {
namespace {

namespace websocket = boost::beast::websocket;
namespace http = boost::beast::http;

using protocol::ClientMessage;
using protocol::Encoding;
using protocol::RejectCode;
using protocol::ServerMessage;
using Clock = std::chrono::steady_clock;

/// A player who has been behind for this long is dropped; the seat stays reserved.
constexpr auto kPlayerGrace = std::chrono::seconds(5);
/// A connection that has been silent for half of it is pinged, after all of it closed.
constexpr auto kIdleTimeout = std::chrono::seconds(60);
constexpr auto kHandshakeTimeout = std::chrono::seconds(10);
constexpr auto kCloseTimeout = std::chrono::seconds(5);
constexpr int kMaxMalformedInARow = 20;
/// The kernel's own buffer would hold minutes of frames before the outbox noticed a slow reader.
constexpr int kSendBufferBytes = 32 * 1024;

class Session final : public Outlet, public std::enable_shared_from_this<Session> {
  public:
    Session(net::Socket socket, AcceptedHandshake handshake, Shard& shard,
            SessionServices& services);

    net::Async<void> run(HttpRequest upgrade);

    void push(Parcel parcel) override;
    void close(CloseReason reason, const std::string& sentence) override;
    void abort() override;

  private:
    void configure();
    void begin();
    void end();
    net::Async<void> read();
    net::Async<void> receive(std::string_view bytes);
    // What becomes of the session by a command.
    net::Async<Standing> carry_out(std::uint32_t seq, const protocol::Ping& command);
    net::Async<Standing> carry_out(std::uint32_t seq, const protocol::EntryCommand& command);
    template <class Command>
    net::Async<Standing> carry_out(std::uint32_t seq, const Command& command);
    template <class Submit>
    net::Async<Standing> submit(std::uint32_t seq, Submit submit);
    void send(const ServerMessage& message);
    void reject(std::uint32_t seq, RejectCode code, std::string reason);
    void write_next();
    void on_written(net::error_code error);

    websocket::stream<net::Socket, false>
        stream_;  // false: permessage-deflate costs more than it saves
    MemberId id_;
    AcceptedHandshake handshake_;
    Shard& shard_;
    SessionServices& services_;

    Standing standing_;
    std::uint32_t last_seq_ = 0;
    int malformed_ = 0;
    RateCredit credit_{Clock::now()};

    Outbox outbox_;
    std::shared_ptr<const std::string> writing_;  ///< what is being written
    std::optional<CloseReason> closing_;
    bool close_sent_ = false;
    std::unique_ptr<LoopTimer> cut_off_;  ///< while closing
};

Session::Session(net::Socket socket, AcceptedHandshake handshake, Shard& shard,
                 SessionServices& services)
    : stream_(std::move(socket)),
      id_{services.last_member.fetch_add(1) + 1},
      handshake_(handshake),
      shard_(shard),
      services_(services) {}

net::Async<void> Session::run(HttpRequest upgrade) {
    configure();
    const auto [error] = co_await stream_.async_accept(upgrade, net::kAwait);
    if (error) co_return;
    upgrade = {};  // not needed for the hours that a session may last
    begin();
    std::exception_ptr failure;
    try {
        co_await read();
    } catch (...) {
        failure = std::current_exception();
    }
    end();
    if (failure) std::rethrow_exception(failure);
}

void Session::configure() {
    net::error_code ignored;  // without it the session is only less well tuned
    stream_.next_layer().set_option(net::socket_base::send_buffer_size(kSendBufferBytes), ignored);
    stream_.read_message_max(protocol::kMaxClientMessageBytes);
    stream_.auto_fragment(false);
    stream_.set_option(websocket::stream_base::timeout{kHandshakeTimeout, kIdleTimeout, true});
    stream_.set_option(
        websocket::stream_base::decorator([this](websocket::response_type& response) {
            response.set(http::field::server,
                         boost::beast::string_view(kServerName.data(), kServerName.size()));
            const std::string_view name = handshake_.subprotocol;
            if (!name.empty())
                response.set(http::field::sec_websocket_protocol,
                             boost::beast::string_view(name.data(), name.size()));
        }));
    // Pings are answered by the library; they cost a credit all the same.
    stream_.control_callback([this](websocket::frame_type type, boost::beast::string_view) {
        if (type == websocket::frame_type::ping && !credit_.spend(Clock::now())) abort();
    });
    if (handshake_.encoding == Encoding::kJson)
        stream_.text(true);
    else
        stream_.binary(true);
}

void Session::begin() {
    shard_.add(id_, weak_from_this());
    services_.counters.sessions.fetch_add(1);
    spdlog::debug("session {} begins", id_.value);
    send(protocol::Welcome{std::string(kServerName), protocol::kVersion});
}

void Session::end() {
    shard_.remove(id_);
    services_.counters.sessions.fetch_sub(1);
    spdlog::debug("session {} ends", id_.value);
    if (standing_.room) standing_.room->disconnect(id_);
    standing_ = {};
    cut_off_.reset();
    abort();
}

/// Goes on reading while the session closes: the read ends once the peer has answered.
net::Async<void> Session::read() {
    boost::beast::flat_buffer buffer;
    for (;;) {
        const auto [error, size] = co_await stream_.async_read(buffer, net::kAwait);
        if (error) co_return;
        if (closing_) {
            // What still comes is of no interest.
        } else if (stream_.got_text() != (handshake_.encoding == Encoding::kJson)) {
            close(CloseReason::kUnsupported,
                  handshake_.encoding == Encoding::kJson
                      ? "This session speaks JSON: send text messages."
                      : "This session speaks CBOR: send binary messages.");
        } else {
            co_await receive({static_cast<const char*>(buffer.data().data()), buffer.size()});
        }
        buffer.consume(buffer.size());
    }
}

net::Async<void> Session::receive(std::string_view bytes) {
    if (!credit_.spend(Clock::now())) {
        close(CloseReason::kPolicy, "Too many messages: at most 60 a second.");
        co_return;
    }
    auto message = protocol::decode_client(bytes, handshake_.encoding);
    if (!message) {
        const protocol::DecodeError& error = message.error();
        reject(error.seq, error.code, error.reason);
        if (++malformed_ >= kMaxMalformedInARow)
            close(CloseReason::kPolicy, "Too many malformed messages.");
        co_return;
    }
    malformed_ = 0;
    if (message->seq <= last_seq_) {
        reject(message->seq, RejectCode::kStaleSeq,
               "seq must be above " + std::to_string(last_seq_) + ".");
        co_return;
    }
    last_seq_ = message->seq;
    standing_ = co_await std::visit(
        [&](const auto& command) { return carry_out(message->seq, command); }, message->body);
}

net::Async<Standing> Session::carry_out(std::uint32_t seq, const protocol::Ping&) {
    send(protocol::Pong{seq});
    co_return standing_;
}

net::Async<Standing> Session::carry_out(std::uint32_t seq, const protocol::EntryCommand& command) {
    return submit(seq, [&lobby = services_.lobby, command](Request request) {
        lobby.enter(std::move(request), command);
    });
}

/// All else is for the match that the session is in.
template <class Command>
net::Async<Standing> Session::carry_out(std::uint32_t seq, const Command& command) {
    return submit(seq, [room = standing_.room, command](Request request) {
        if (room) return room->submit(std::move(request), command);
        std::move(request).reject({RejectCode::kNotInMatch, "You are in no match."});
    });
}

/// Hands a command on and waits until it has been answered.
template <class Submit>
net::Async<Standing> Session::submit(std::uint32_t seq, Submit submit) {
    return net::await_callback<Standing>(
        [self = shared_from_this(), seq, submit = std::move(submit)](auto resume) {
            const auto done = [&loop = self->shard_.loop(), resume](Standing standing) {
                loop.post([resume, standing = std::move(standing)] { resume(standing); });
            };
            const Member member{self->id_, self->shard_.id(), self->handshake_.encoding};
            submit(Request({self->services_.shards, self->services_.counters, member, seq,
                            self->standing_, done}));
        });
}

// ---- what goes out

void Session::reject(std::uint32_t seq, RejectCode code, std::string reason) {
    services_.counters.rejects.fetch_add(1, std::memory_order_relaxed);
    send(protocol::Reject{seq, code, std::move(reason)});
}

void Session::send(const ServerMessage& message) {
    push({std::make_shared<const ServerMessage>(message), nullptr});
}

void Session::push(Parcel parcel) {
    if (closing_ || !stream_.next_layer().is_open()) return;
    const auto now = Clock::now();
    const bool fits = outbox_.push(std::move(parcel), now);
    if (!fits || (standing_.seated && outbox_.lag(now) > kPlayerGrace)) {
        outbox_.clear();
        return close(CloseReason::kPolicy, "You read too slowly.");
    }
    write_next();
}

void Session::write_next() {
    if (writing_ || close_sent_) return;
    auto parcel = outbox_.pop();
    if (!parcel) {
        if (!closing_) return;
        close_sent_ = true;
        const auto code = static_cast<websocket::close_code>(static_cast<std::uint16_t>(*closing_));
        return stream_.async_close(code, [self = shared_from_this()](net::error_code) {});
    }
    writing_ =
        parcel->bytes
            ? std::move(parcel->bytes)
            : std::make_shared<const std::string>(encode(*parcel->message, handshake_.encoding));
    // A plain handler: a coroutine for each message would cost more than the message.
    stream_.async_write(net::buffer(*writing_),
                        [self = shared_from_this()](net::error_code error, std::size_t) {
                            self->on_written(error);
                        });
}

void Session::on_written(net::error_code error) {
    services_.counters.messages_sent.fetch_add(1, std::memory_order_relaxed);
    services_.counters.bytes_sent.fetch_add(writing_->size(), std::memory_order_relaxed);
    writing_.reset();
    if (error) return abort();
    write_next();
}

void Session::close(CloseReason reason, const std::string& sentence) {
    if (closing_) return;
    spdlog::debug("session {} closes: {}", id_.value, sentence);
    send(protocol::Closing{sentence});
    closing_ = reason;
    write_next();
    // A peer that does not read cannot be told; it is cut off.
    cut_off_ = std::make_unique<LoopTimer>(shard_.loop());
    cut_off_->at(Clock::now() + kCloseTimeout, [this] { abort(); });
}

void Session::abort() {
    net::error_code ignored;  // it is gone either way
    stream_.next_layer().close(ignored);
}

}  // namespace

net::Async<void> run_session(net::Socket socket, HttpRequest upgrade, AcceptedHandshake handshake,
                             Shard& shard, SessionServices& services) {
    const auto session = std::make_shared<Session>(std::move(socket), handshake, shard, services);
    co_await session->run(std::move(upgrade));
}

}  // namespace poolhall::server
