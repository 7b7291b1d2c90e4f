#pragma once

#include "server/base/counters.hpp"
#include "server/config/config.hpp"
#include "shared/result.hpp"

#include <memory>
#include <string>

namespace poolhall::server {

/// The whole server, on threads of its own.
class Server {
  public:
    /// Opens the store, brings back the matches that were open, and serves. The error is one line.
    [[nodiscard]] static Result<std::unique_ptr<Server>, std::string> start(
        const ServerConfig& config);

    /// Drains, if that has not been done.
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    Server(Server&&) = delete;
    Server& operator=(Server&&) = delete;

    /// ADDR:PORT
    [[nodiscard]] std::string address() const;
    [[nodiscard]] const Counters& counters() const;

    /// Takes no new matches, tells every session why it is closed, and saves. At most a few
    /// seconds.
    void drain();

  private:
    struct State;
    explicit Server(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace poolhall::server
