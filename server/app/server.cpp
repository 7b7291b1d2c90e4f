#include "server/app/server.hpp"

#include "server/http/connection.hpp"
#include "server/net/listener.hpp"
#include "server/room/rebuild.hpp"

#include <boost/asio/thread_pool.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <thread>
#include <utility>
#include <vector>

namespace poolhall::server {
namespace {

constexpr auto kMaxSweepInterval = std::chrono::milliseconds(5000);
/// For sessions to take their last messages and answer the close; after it they are cut off.
constexpr auto kDrainTime = std::chrono::seconds(2);
constexpr auto kCutOffTime = std::chrono::seconds(2);

/// How many connections there may be: as many as there are sessions, and as files that this process
/// may have open beside those of the store.
std::size_t connection_limit(const ServerConfig& config) {
    constexpr std::size_t kSpareConnections =
        64;  // for HTTP, and to be told that the server is full
    constexpr std::size_t kOtherFiles = 64;
    rlimit files{};
    const std::size_t wanted = config.max_sessions + kSpareConnections;
    if (getrlimit(RLIMIT_NOFILE, &files) != 0 || files.rlim_cur == RLIM_INFINITY) return wanted;
    const std::size_t possible =
        files.rlim_cur - std::min<std::size_t>(files.rlim_cur / 2, kOtherFiles);
    if (possible >= wanted) return wanted;
    spdlog::warn("at most {} connections: the limit of open files is {}", possible, files.rlim_cur);
    return possible;
}

std::chrono::milliseconds sweep_interval(std::uint32_t idle_timeout) {
    return std::min<std::chrono::milliseconds>(kMaxSweepInterval,
                                               std::chrono::milliseconds(250) * idle_timeout);
}

}  // namespace

struct Server::State {
    State(const ServerConfig& config, std::unique_ptr<ReplayStore> opened,
          std::unique_ptr<Shards> made, std::unique_ptr<Listener> bound)
        : admission({connection_limit(config), config.max_per_address}, counters),
          store(std::move(opened)),
          shards(std::move(made)),
          listener(std::move(bound)),
          lobby({*store,
                 *shards,
                 counters,
                 {config.max_spectators, std::chrono::seconds(config.idle_timeout)},
                 config.max_matches}),
          sessions{lobby, *shards, counters},
          http{admission,
               sessions,
               {lobby, *store, counters, [this] { return !draining.load(); }},
               readers,
               config.allow_origin,
               config.max_sessions},
          sweep_timer(shards->at({}).loop()),
          sweep_every(sweep_interval(config.idle_timeout)) {}

    void reopen_matches(const OpenMatches& open);
    void schedule_sweep();
    bool wait_for_sessions(std::chrono::milliseconds limit) const;
    void run_rest() const;

    Counters counters;
    Admission admission;  // before the loops, which have connections to the end
    std::unique_ptr<ReplayStore> store;
    std::unique_ptr<Shards> shards;
    std::unique_ptr<Listener> listener;
    Lobby lobby;
    boost::asio::thread_pool readers{1};
    std::atomic<bool> draining{false};
    SessionServices sessions;
    HttpServices http;
    LoopTimer sweep_timer;
    std::chrono::milliseconds sweep_every;
};

void Server::State::reopen_matches(const OpenMatches& open) {
    for (const std::string& damage : open.damaged)
        spdlog::error("{}", damage);
    for (const StoredMatch& stored : open.matches) {
        auto table = rebuild(stored);
        if (table)
            lobby.reopen(std::move(*table));
        else
            spdlog::error("match {} is not opened again: {}", stored.id, table.error());
    }
    if (lobby.size() > 0) spdlog::info("{} open matches brought back from the store", lobby.size());
}

/// The one timer of a server at rest; coarse, and one for all matches.
void Server::State::schedule_sweep() {
    sweep_timer.at(LoopTimer::Clock::now() + sweep_every, [this] {
        lobby.sweep();
        schedule_sweep();
    });
}

bool Server::State::wait_for_sessions(std::chrono::milliseconds limit) const {
    constexpr auto kStep = std::chrono::milliseconds(5);
    for (auto waited = kStep * 0; counters.sessions.load() > 0; waited += kStep) {
        if (waited > limit) return false;
        std::this_thread::sleep_for(kStep);
    }
    return true;
}

/// Tasks that are left hold sessions of other loops, which must be gone before those loops are; and
/// every command that was begun is answered.
void Server::State::run_rest() const {
    for (bool ran = true; ran;) {
        store->flush();
        ran = shards->run_ready();
    }
}

Result<std::unique_ptr<Server>, std::string> Server::start(const ServerConfig& config) {
    auto shards = std::make_unique<Shards>(config.threads);
    auto listener = Listener::bind(config.listen, shards->at({}).loop());
    if (!listener) return listener.error();
    auto store = ReplayStore::open({config.data});
    if (!store) return store.error().reason;
    auto open = (*store)->load_open_matches();
    if (!open) return open.error().reason;

    auto state =
        std::make_unique<State>(config, std::move(*store), std::move(shards), std::move(*listener));
    state->reopen_matches(*open);
    state->listener->start(
        state->shards->loops(), [&state = *state](net::Socket socket, std::size_t loop) {
            const ShardId shard{static_cast<std::uint32_t>(loop)};
            serve_connection(std::move(socket), state.shards->at(shard), state.http);
        });
    state->schedule_sweep();
    state->shards->start();
    spdlog::info("listening on {}, {} threads, data in {}", state->listener->address(),
                 config.threads, config.data);
    return std::unique_ptr<Server>(new Server(std::move(state)));
}

Server::Server(std::unique_ptr<State> state) : state_(std::move(state)) {}

Server::~Server() {
    drain();
    // Loops first: what they run uses the rest.
    state_->shards->stop();
    state_->readers.join();
    state_->run_rest();
    state_->store.reset();
}

std::string Server::address() const {
    return state_->listener->address();
}

const Counters& Server::counters() const {
    return state_->counters;
}

void Server::drain() {
    if (state_->draining.exchange(true)) return;
    spdlog::info("shutting down: {} sessions, {} matches", state_->counters.sessions.load(),
                 state_->lobby.size());
    state_->lobby.close();
    state_->listener->stop();
    state_->shards->post_to_all([](Outlet& session) {
        session.close(CloseReason::kGoingAway, "The server is shutting down.");
    });
    if (state_->wait_for_sessions(kDrainTime)) return;
    state_->shards->post_to_all([](Outlet& session) { session.abort(); });
    if (!state_->wait_for_sessions(kCutOffTime)) spdlog::warn("some sessions did not end");
}

}  // namespace poolhall::server
