#pragma once

#include "server/session/connection_services.hpp"
#include "shared/result.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace poolhall::server {

/// Takes connections and deals them out to the shards.
class Listener {
  public:
    /// Binds ADDR:PORT ("127.0.0.1:8080", "[::1]:0"); the error is one line that names it.
    [[nodiscard]] static Result<std::unique_ptr<Listener>, std::string> bind(
        std::string_view address, Shard& shard);
    ~Listener();
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;
    Listener(Listener&&) = delete;
    Listener& operator=(Listener&&) = delete;

    /// Begins to take connections. `shards` and `services` must outlive the loops.
    void start(std::vector<Shard*> shards, ConnectionServices& services);
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
