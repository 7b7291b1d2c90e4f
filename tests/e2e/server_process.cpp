#include "tests/e2e/server_process.hpp"

#include <signal.h>
#include <stdexcept>
#include <thread>

namespace poolhall::e2e {
namespace {

constexpr std::string_view kReady = "listening on 127.0.0.1:";

std::uint16_t await_port(ChildProcess& server) {
    const auto end = std::chrono::steady_clock::now() + ChildProcess::kPatience;
    while (std::chrono::steady_clock::now() < end) {
        const bool ended = server.status().has_value();
        const std::string out = server.out();
        if (out.starts_with(kReady) && out.find('\n') != std::string::npos)
            return static_cast<std::uint16_t>(std::stoi(out.substr(kReady.size())));
        if (ended) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    throw std::runtime_error("the server does not listen; it wrote: " + server.out() +
                             server.err());
}

}  // namespace

std::vector<std::string> server_command(const std::filesystem::path& data,
                                        std::vector<std::string> flags) {
    std::vector<std::string> command{POOLHALL_SERVER, "--listen", "127.0.0.1:0", "--data", data};
    command.insert(command.end(), flags.begin(), flags.end());
    return command;
}

ServerProcess::ServerProcess(const std::filesystem::path& data, std::vector<std::string> flags)
    : process_(server_command(data, std::move(flags))), port_(await_port(process_)) {}

void ServerProcess::kill() {
    process_.signal(SIGKILL);
    process_.wait();
}

int ServerProcess::terminate() {
    process_.signal(SIGTERM);
    return process_.wait();
}

}  // namespace poolhall::e2e
