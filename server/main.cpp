#include "server/app/server.hpp"
#include "server/config/config.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <unistd.h>

namespace {

using namespace poolhall::server;

/// The signals that end the server; blocked everywhere, so that only sigwait() takes them.
sigset_t ending_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

[[noreturn]] void exit_at_once(int signal) {
    _exit(128 + signal);
}

/// From now on a further signal ends the program where it stands.
void let_signals_kill(const sigset_t& set) {
    std::signal(SIGINT, exit_at_once);
    std::signal(SIGTERM, exit_at_once);
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

/// Each session is a file descriptor; the usual soft limit of 1024 is for programs that use
/// select().
void raise_file_limit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
    limit.rlim_cur = limit.rlim_max;
    setrlimit(RLIMIT_NOFILE, &limit);
}

void start_logging(const ServerConfig& config) {
    const auto logger = spdlog::stderr_color_mt("poolhall");
    logger->set_pattern("%Y-%m-%dT%H:%M:%S.%e%z %^%l%$ %v");
    logger->set_level(spdlog::level::from_str(config.log_level));
    logger->flush_on(spdlog::level::info);
    spdlog::set_default_logger(logger);
}

int fail(const std::string& line, int status) {
    std::fprintf(stderr, "%s\n", line.c_str());
    return status;
}

int serve(const ServerConfig& config) {
    const sigset_t signals = ending_signals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    raise_file_limit();
    start_logging(config);
    const auto server = Server::start(config);
    if (!server) return fail("poolhall-server: " + server.error(), EXIT_FAILURE);
    std::printf("listening on %s\n", (*server)->address().c_str());
    std::fflush(stdout);
    int signal = 0;
    sigwait(&signals, &signal);
    let_signals_kill(signals);
    (*server)->drain();
    return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const auto config = load_config(argc, argv);
        if (config) return serve(*config);
        if (config.error().status != 0) return fail(config.error().text, config.error().status);
        std::fputs(config.error().text.c_str(), stdout);
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        return fail(std::string("poolhall-server: ") + error.what(), EXIT_FAILURE);
    }
}
