#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace poolhall::e2e {

/// A folder of its own for a test, removed with everything in it.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// A program of ours that runs while the object lives, and no longer: not if the test fails, nor if
/// the test itself is killed.
class ChildProcess {
  public:
    /// Long enough for a machine under load; nothing waits this long when all is well.
    static constexpr std::chrono::seconds kPatience{20};

    /// Starts the program. What it writes goes to files, to be read with out() and err().
    explicit ChildProcess(std::vector<std::string> command);
    /// Asks it to end (SIGTERM), then makes it (SIGKILL).
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// What it has written so far on standard output and standard error.
    [[nodiscard]] std::string out() const;
    [[nodiscard]] std::string err() const;

    [[nodiscard]] pid_t id() const { return pid_; }

    void signal(int number) const;

    /// Its exit status, or minus the signal that ended it. Nothing if it still runs.
    std::optional<int> status();
    /// The same, but waits for its end; throws std::runtime_error if that takes too long.
    int wait();

  private:
    std::optional<int> wait_for(std::chrono::seconds patience);

    TemporaryFolder folder_;
    pid_t pid_ = -1;
    std::optional<int> status_;
};

/// What a program that has ended left.
struct Finished {
    int status = 0;
    std::string out;
    std::string err;
};

/// Runs a program to its end.
[[nodiscard]] Finished run(std::vector<std::string> command);

}  // namespace poolhall::e2e
