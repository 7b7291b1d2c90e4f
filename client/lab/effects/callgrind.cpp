#include "client/lab/effects/callgrind.hpp"

#include "client/lab/run/progress.hpp"
#include "protocol/codec/scene_json.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <string_view>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace poolhall::lab {

namespace {

namespace fs = std::filesystem;

/// A new folder that goes with all that is in it.
class ScratchFolder {
  public:
    ScratchFolder() {
        std::string pattern = (fs::temp_directory_path() / "poolhall-XXXXXX").string();
        if (mkdtemp(pattern.data()) != nullptr) path_ = pattern;
    }

    ~ScratchFolder() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }

    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    /// Empty if it could not be made.
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

fs::path scenes_in(const fs::path& folder) {
    return folder / "shots.jsonl";
}

fs::path profile_in(const fs::path& folder) {
    return folder / "profile";
}

bool write_scenes(const fs::path& file, const std::vector<Scene>& shots) {
    std::ofstream out(file);
    for (const Scene& scene : shots)
        out << protocol::to_json(scene).dump() << '\n';
    return static_cast<bool>(out.flush());
}

/// What the profile counted in all.
std::optional<double> total_of(const fs::path& profile) {
    constexpr std::string_view kTotal = "totals: ";
    std::ifstream in(profile);
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with(kTotal)) return std::strtod(line.c_str() + kTotal.size(), nullptr);
    }
    return std::nullopt;
}

/// Its exit status; ends it at Ctrl-C.
int wait_for(pid_t process) {
    using namespace std::chrono_literals;
    int status = 0;
    while (waitpid(process, &status, WNOHANG) == 0) {
        if (Interruption::asked_for()) kill(process, SIGKILL);
        std::this_thread::sleep_for(5ms);
    }
    return status;
}

}  // namespace

std::optional<double> Callgrind::instructions_of(const std::vector<Scene>& shots) {
    if (fault_) return std::nullopt;
    const ScratchFolder folder;
    if (folder.path().empty() || !write_scenes(scenes_in(folder.path()), shots)) {
        fault_ = fs::temp_directory_path().string() + " cannot be written";
        return std::nullopt;
    }
    run(folder.path());
    return fault_ ? std::nullopt : total_of(profile_in(folder.path()));
}

void Callgrind::run(const fs::path& folder) {
    std::array<std::string, 8> words{"valgrind",
                                     "--tool=callgrind",
                                     "--quiet",
                                     "--callgrind-out-file=" + profile_in(folder).string(),
                                     "--toggle-collect=poolhall::Simulator::simulate(*",
                                     lab_.string(),
                                     "simulate",
                                     scenes_in(folder).string()};
    std::array<char*, words.size() + 1> arguments{};
    for (std::size_t i = 0; i < words.size(); ++i)
        arguments[i] = words[i].data();
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
    pid_t process = 0;
    const int error =
        posix_spawnp(&process, "valgrind", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        fault_ = "valgrind cannot be run: " + std::generic_category().message(error);
    } else if (wait_for(process) != 0 && !Interruption::asked_for()) {
        fault_ = "valgrind cannot count instructions of " + lab_.string();
    }
}

}  // namespace poolhall::lab
