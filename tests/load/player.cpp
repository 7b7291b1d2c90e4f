#include "tests/load/player.hpp"

#include "protocol/limits.hpp"

#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <deque>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

namespace poolhall::load {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using net::ip::tcp;
using protocol::Encoding;
using protocol::Phase;
using protocol::TableState;
using Error = boost::system::error_code;

struct Player::State : std::enable_shared_from_this<State> {
    State(net::io_context& context, Encoding spoken) : stream(context), encoding(spoken) {}

    void connect(std::uint16_t port);
    void send(protocol::ClientBody body);
    void write_next();
    void read_next();
    void take(const protocol::ServerMessage& message, std::size_t size);
    void look_at(const TableState& seen);
    void act();

    websocket::stream<tcp::socket> stream;
    Encoding encoding;
    beast::flat_buffer buffer;
    std::deque<std::string> outbox;
    std::uint32_t seq = 0;
    bool playing = false;
    std::string code;
    std::vector<Seat> seats;
    std::optional<TableState> table;
    std::uint32_t shots_taken = 0;  ///< of the match, when it last shot
    std::uint32_t game_voted = 0;
    bool in_shot = false;
    std::uint64_t messages = 0;
    std::uint64_t shots = 0;
    Traffic current;  ///< of the shot that runs
    Traffic traffic;
};

void Player::State::connect(std::uint16_t port) {
    stream.next_layer().connect({net::ip::address_v4::loopback(), port});
    stream.next_layer().set_option(tcp::no_delay(true));
    const std::string_view name =
        encoding == Encoding::kJson ? protocol::kSubprotocolJson : protocol::kSubprotocolCbor;
    stream.set_option(websocket::stream_base::decorator([name](websocket::request_type& request) {
        request.set(beast::http::field::sec_websocket_protocol,
                    beast::string_view(name.data(), name.size()));
    }));
    stream.handshake("127.0.0.1:" + std::to_string(port), std::string(protocol::kPath));
    stream.read_message_max(protocol::kMaxServerMessageBytes);
    stream.text(encoding == Encoding::kJson);
    stream.binary(encoding == Encoding::kCbor);
}

void Player::State::send(protocol::ClientBody body) {
    outbox.push_back(encode(protocol::ClientMessage{++seq, std::move(body)}, encoding));
    if (outbox.size() == 1) write_next();
}

void Player::State::write_next() {
    stream.async_write(net::buffer(outbox.front()),
                       [self = shared_from_this()](Error error, std::size_t) {
                           if (error) return;
                           self->outbox.pop_front();
                           if (!self->outbox.empty()) self->write_next();
                       });
}

void Player::State::read_next() {
    buffer.clear();
    stream.async_read(buffer, [self = shared_from_this()](Error error, std::size_t size) {
        if (error) return;
        const auto message =
            protocol::decode_server(beast::buffers_to_string(self->buffer.data()), self->encoding);
        if (!message) throw std::runtime_error(message.error().reason);
        self->take(*message, size);
        self->read_next();
    });
}

void Player::State::take(const protocol::ServerMessage& message, std::size_t size) {
    using namespace protocol;
    if (std::holds_alternative<ShotStarted>(message)) in_shot = true;
    ++messages;
    if (in_shot && !std::holds_alternative<TableChanged>(message)) {
        ++current.messages;
        current.bytes += size;
    }
    if (const auto* joined = std::get_if<Joined>(&message)) {
        code = joined->table.code;
        seats = joined->seats;
        look_at(joined->table);
    } else if (const auto* changed = std::get_if<TableChanged>(&message)) {
        look_at(changed->table);
    } else if (const auto* ended = std::get_if<ShotEnded>(&message)) {
        in_shot = false;
        ++shots;
        traffic.messages += std::exchange(current.messages, 0);
        traffic.bytes += std::exchange(current.bytes, 0);
        look_at(ended->table);
    } else if (const auto* reject = std::get_if<Reject>(&message)) {
        throw std::runtime_error("rejected: " + reject->reason);
    }
}

void Player::State::look_at(const TableState& seen) {
    table = seen;
    act();
}

void Player::State::act() {
    if (!playing || !table) return;
    for (const Seat seat : seats) {
        const bool may_shoot = table->phase == Phase::kAiming && table->legal.seat == seat;
        if (may_shoot && shots_taken != table->shot + 1) {
            shots_taken = table->shot + 1;
            // Past the 8-ball's middle by a little more each time: some of these shots end the
            // game.
            const double side = 0.04 * static_cast<double>(table->shot % 21) - 0.4;
            const Vec2 direction{table->legal.aim.x, table->legal.aim.y + side};
            send(protocol::MakeMove{seat, Shoot{Stroke{direction, {}}}});
        }
        if (table->phase == Phase::kOver && game_voted != table->game_number) {
            game_voted = table->game_number;
            send(protocol::MakeMove{seat, Agree{}});
        }
    }
}

Player::Player(net::io_context& context, std::uint16_t port, Encoding encoding)
    : state_(std::make_shared<State>(context, encoding)) {
    state_->connect(port);
    state_->read_next();
}

Player::~Player() {
    Error ignored;
    if (state_) state_->stream.next_layer().close(ignored);
}

Player::Player(Player&&) noexcept = default;
Player& Player::operator=(Player&&) noexcept = default;

void Player::send(protocol::ClientBody body) {
    state_->send(std::move(body));
}

void Player::set_playing(bool playing) {
    state_->playing = playing;
    state_->act();
}

const std::string& Player::code() const {
    return state_->code;
}

std::uint64_t Player::messages() const {
    return state_->messages;
}

std::uint64_t Player::shots() const {
    return state_->shots;
}

const Traffic& Player::shot_traffic() const {
    return state_->traffic;
}

}  // namespace poolhall::load
