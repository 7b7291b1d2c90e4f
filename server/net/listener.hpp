#pragma once

#include "server/net/asio.hpp"
#include "server/net/loop.hpp"
#include "shared/result.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace poolhall::server {

/// Takes connections and deals them out to loops.
class Listener {
  public:
    /// Binds ADDR:PORT ("127.0.0.1:8080", "[::1]:0"); the error is one line that names it.
    [[nodiscard]] static Result<std::unique_ptr<Listener>, std::string> bind(
        std::string_view address, Loop& home);
    ~Listener();
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;
    Listener(Listener&&) = delete;
    Listener& operator=(Listener&&) = delete;

    /// Serves a connection that belongs to one of the loops, by its index. Called on the home loop.
    using Serve = std::function<void(net::Socket socket, std::size_t loop)>;

    /// Begins to take connections. `loops` must live until the home loop has stopped.
    void start(std::vector<Loop*> loops, Serve serve);
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
