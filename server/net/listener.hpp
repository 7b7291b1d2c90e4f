#pragma once

#include "server/base/counters.hpp"
#include "server/net/asio.hpp"
#include "server/net/loop.hpp"
#include "shared/result.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace poolhall::server {

/// What a listener needs of the server; outlives it.
struct ListenerServices {
    std::vector<Loop*> loops;  ///< that connections are dealt out to in turn
    const Counters& counters;
    std::int64_t max_sessions = 0;
    /// Serves a connection, on the loop of that place in `loops`.
    std::function<net::Async<void>(net::Socket socket, std::size_t loop)> serve;
};

/// Takes connections and deals them out to the loops.
class Listener {
  public:
    /// Binds ADDR:PORT ("127.0.0.1:8080", "[::1]:0"); the error is one line that names it.
    [[nodiscard]] static Result<std::unique_ptr<Listener>, std::string> bind(
        std::string_view address, Loop& loop);
    ~Listener();
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;
    Listener(Listener&&) = delete;
    Listener& operator=(Listener&&) = delete;

    /// Begins to take connections.
    void start(const ListenerServices& services);
    /// Safe from any thread: takes no more connections.
    void stop();

    /// ADDR:PORT with the port that was really taken.
    [[nodiscard]] std::string address() const;

  private:
    struct State;
    explicit Listener(std::shared_ptr<State> state);

    std::shared_ptr<State> state_;
};

}  // namespace poolhall::server
