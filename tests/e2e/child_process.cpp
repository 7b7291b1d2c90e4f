#include "tests/e2e/child_process.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <signal.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace poolhall::e2e {
namespace {

constexpr std::chrono::milliseconds kPollInterval{2};

std::string read_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// In the child: from here on only what is safe after fork().
[[noreturn]] void become(char* const* command, const char* out, const char* err) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    constexpr int kFlags = O_WRONLY | O_CREAT | O_TRUNC;
    dup2(open(out, kFlags, 0600), STDOUT_FILENO);
    dup2(open(err, kFlags, 0600), STDERR_FILENO);
    execv(command[0], command);
    _exit(127);
}

pid_t start(std::vector<std::string>& command, const std::filesystem::path& folder) {
    std::vector<char*> arguments;
    for (std::string& word : command)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::string out = folder / "out";
    const std::string err = folder / "err";
    const pid_t pid = fork();
    if (pid == 0) become(arguments.data(), out.c_str(), err.c_str());
    if (pid < 0) throw std::system_error(errno, std::generic_category(), "fork");
    return pid;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    std::string name = std::filesystem::temp_directory_path() / "poolhall-e2e-XXXXXX";
    if (mkdtemp(name.data()) == nullptr)
        throw std::system_error(errno, std::generic_category(), name);
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

ChildProcess::ChildProcess(std::vector<std::string> command)
    : pid_(start(command, folder_.path())) {}

ChildProcess::~ChildProcess() {
    if (status()) return;
    signal(SIGTERM);
    if (wait_for(kPatience)) return;
    signal(SIGKILL);
    wait_for(kPatience);
}

std::string ChildProcess::out() const {
    return read_file(folder_.path() / "out");
}

std::string ChildProcess::err() const {
    return read_file(folder_.path() / "err");
}

void ChildProcess::signal(int number) const {
    // Once reaped, the id may be somebody else's.
    if (!status_) ::kill(pid_, number);
}

std::optional<int> ChildProcess::status() {
    int raw = 0;
    if (!status_ && waitpid(pid_, &raw, WNOHANG) == pid_)
        status_ = WIFSIGNALED(raw) ? -WTERMSIG(raw) : WEXITSTATUS(raw);
    return status_;
}

std::optional<int> ChildProcess::wait_for(std::chrono::seconds patience) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (!status() && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(kPollInterval);
    return status_;
}

int ChildProcess::wait() {
    if (const auto ended = wait_for(kPatience)) return *ended;
    throw std::runtime_error("a program did not end; it wrote: " + out() + err());
}

Finished run(std::vector<std::string> command) {
    ChildProcess child(std::move(command));
    const int status = child.wait();
    return {status, child.out(), child.err()};
}

}  // namespace poolhall::e2e
