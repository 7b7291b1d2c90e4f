#pragma once

#include "tests/e2e/child_process.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poolhall::e2e {

/// The command line of poolhall-server on a free port of this machine, with its data in `data`.
[[nodiscard]] std::vector<std::string> server_command(const std::filesystem::path& data,
                                                      std::vector<std::string> flags = {});

/// The real poolhall-server, ready for connections.
class ServerProcess {
  public:
    /// Returns when it listens; throws std::runtime_error, with what it said, if it does not.
    explicit ServerProcess(const std::filesystem::path& data, std::vector<std::string> flags = {});

    [[nodiscard]] std::uint16_t port() const { return port_; }

    [[nodiscard]] ChildProcess& process() { return process_; }

    /// The end that a power cut gives: SIGKILL.
    void kill();
    /// SIGTERM; returns the exit status.
    int terminate();

  private:
    ChildProcess process_;
    std::uint16_t port_ = 0;
};

}  // namespace poolhall::e2e
