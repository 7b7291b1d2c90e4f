#include "tests/e2e/protocol_client.hpp"

#include "protocol/codec/codec.hpp"
#include "protocol/limits.hpp"

#include <variant>

namespace poolhall::e2e {

using namespace protocol;

namespace {

std::string_view subprotocol_of(Encoding encoding) {
    return encoding == Encoding::kJson ? kSubprotocolJson : kSubprotocolCbor;
}

}  // namespace

ProtocolClient::ProtocolClient(std::uint16_t port, Encoding encoding)
    : encoding_(encoding), socket_(port, subprotocol_of(encoding)) {
    const Heard first = hear();
    if (!std::holds_alternative<Welcome>(first.message))
        throw std::runtime_error("the first message is not a welcome");
}

std::uint32_t ProtocolClient::send(ClientBody body) {
    send_as(++seq_, std::move(body));
    return seq_;
}

void ProtocolClient::send_as(std::uint32_t seq, ClientBody body) {
    const ClientMessage message{seq, std::move(body)};
    socket_.send(encode(message, encoding_), encoding_ == Encoding::kJson);
}

void ProtocolClient::request(ClientBody body) {
    const std::uint32_t seq = send(std::move(body));
    await<Accepted>([seq](const Accepted& accepted) { return accepted.seq == seq; });
}

Joined ProtocolClient::enter(ClientBody body) {
    const std::uint32_t seq = send(std::move(body));
    return await<Joined>([seq](const Joined& joined) { return joined.seq == seq; });
}

Reject ProtocolClient::refused(ClientBody body) {
    const std::uint32_t seq = send(std::move(body));
    return await<Reject>([seq](const Reject& reject) { return reject.seq == seq; });
}

Heard ProtocolClient::hear() {
    const auto arrival = socket_.receive(kPatience);
    if (!arrival) throw std::runtime_error("the server has closed the connection");
    if (arrival->text != (encoding_ == Encoding::kJson))
        throw std::runtime_error("the server mixed text and binary messages");
    auto message = decode_server(arrival->bytes, encoding_);
    if (!message)
        throw std::runtime_error("the server sent what is no message: " + message.error().reason);
    return {std::move(*message), arrival->at};
}

TableState ProtocolClient::await_table(const std::function<bool(const TableState&)>& wanted) {
    return await<TableChanged>([&](const TableChanged& changed) { return wanted(changed.table); })
        .table;
}

ShotHeard ProtocolClient::hear_shot() {
    ShotHeard shot{await<ShotStarted>(), {}, {}, {}};
    for (;;) {
        Heard heard = hear();
        if (Frame* frame = std::get_if<Frame>(&heard.message)) {
            shot.frames.push_back(std::move(*frame));
            shot.frame_times.push_back(heard.at);
        } else if (ShotEnded* ended = std::get_if<ShotEnded>(&heard.message)) {
            shot.ended = std::move(*ended);
            return shot;
        } else {
            throw_if_refused(heard.message);
        }
    }
}

void ProtocolClient::throw_if_refused(const ServerMessage& message) {
    if (const Reject* reject = std::get_if<Reject>(&message))
        throw std::runtime_error("rejected: " + reject->reason);
    if (const Closing* closing = std::get_if<Closing>(&message))
        throw std::runtime_error("closing: " + closing->reason);
}

}  // namespace poolhall::e2e
