#include "server/net/listener.hpp"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>

#include <charconv>
#include <optional>
#include <spdlog/spdlog.h>
#include <sstream>
#include <utility>

namespace poolhall::server {
namespace {

/// Taken in one go before ticks get their turn again.
constexpr int kBatch = 64;
/// After an error such as "too many open files", which only time heals.
constexpr auto kRetry = std::chrono::milliseconds(100);
constexpr auto kComplainEvery = std::chrono::seconds(10);

std::optional<net::ip::tcp::endpoint> parse_endpoint(std::string_view text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos) return std::nullopt;
    std::string host(text.substr(0, colon));
    if (host.size() > 2 && host.front() == '[' && host.back() == ']')
        host = host.substr(1, host.size() - 2);
    std::uint16_t port = 0;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data() + colon + 1, end, port);
    if (fault != std::errc() || stop != end) return std::nullopt;
    net::error_code error;
    const auto address = net::ip::make_address(host, error);
    if (error) return std::nullopt;
    return net::ip::tcp::endpoint(address, port);
}

}  // namespace

struct Listener::State {
    State(Loop& where, net::ip::tcp::endpoint bound)
        : home(where), acceptor(where.context().get_executor()), endpoint(std::move(bound)) {}

    Loop& home;
    net::Acceptor acceptor;
    net::ip::tcp::endpoint endpoint;
    std::vector<Loop*> loops;
    Serve serve;
    std::size_t next = 0;
    std::chrono::steady_clock::time_point complained{};

    void open(net::error_code& error);
    net::Async<void> run();
    net::error_code take_batch();
    void complain(net::error_code error);
};

void Listener::State::open(net::error_code& error) {
    acceptor.open(endpoint.protocol(), error);
    if (!error) acceptor.set_option(net::socket_base::reuse_address(true), error);
    if (!error) acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(net::socket_base::max_listen_connections, error);
    if (!error) acceptor.non_blocking(true, error);
    if (!error) endpoint = acceptor.local_endpoint(error);
}

/// Waits once, then takes all that are there: with one wait for each connection, a storm of them
/// stalls.
net::Async<void> Listener::State::run() {
    net::Timer retry(acceptor.get_executor());
    while (acceptor.is_open()) {
        const auto [failed] =
            co_await acceptor.async_wait(net::socket_base::wait_read, net::kAwait);
        if (failed) co_return;
        const net::error_code error = take_batch();
        if (!error) continue;
        complain(error);
        retry.expires_after(kRetry);
        co_await retry.async_wait(net::kAwait);
    }
}

net::error_code Listener::State::take_batch() {
    for (int taken = 0; taken < kBatch; ++taken) {
        const std::size_t loop = next++ % loops.size();
        net::error_code error;
        net::Socket socket = acceptor.accept(loops[loop]->context().get_executor(), error);
        if (error == net::error::would_block) return {};
        if (error == net::error::connection_aborted) continue;
        if (error) return error;
        serve(std::move(socket), loop);
    }
    return {};
}

void Listener::State::complain(net::error_code error) {
    const auto now = std::chrono::steady_clock::now();
    if (complained != decltype(complained){} && now - complained < kComplainEvery) return;
    complained = now;
    spdlog::warn("connections cannot be taken for now: {}", error.message());
}

Result<std::unique_ptr<Listener>, std::string> Listener::bind(std::string_view address,
                                                              Loop& home) {
    const auto endpoint = parse_endpoint(address);
    if (!endpoint)
        return "cannot listen on '" + std::string(address) + "': it is not of the form ADDR:PORT";
    auto state = std::make_shared<State>(home, *endpoint);
    net::error_code error;
    state->open(error);
    if (error) return "cannot listen on " + std::string(address) + ": " + error.message();
    return std::unique_ptr<Listener>(new Listener(std::move(state)));
}

Listener::Listener(std::shared_ptr<State> state) : state_(std::move(state)) {}

Listener::~Listener() = default;

void Listener::start(std::vector<Loop*> loops, Serve serve) {
    state_->loops = std::move(loops);
    state_->serve = std::move(serve);
    const auto run = [state = state_]() -> net::Async<void> { co_await state->run(); };
    net::co_spawn(state_->home.context().get_executor(), run, net::detached);
}

void Listener::stop() {
    state_->home.post([state = state_] {
        net::error_code ignored;  // it is closed either way
        state->acceptor.close(ignored);
    });
}

std::string Listener::address() const {
    std::ostringstream text;
    text << state_->endpoint;
    return text.str();
}

}  // namespace poolhall::server
