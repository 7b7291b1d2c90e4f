#include "client/desktop/net/token_store.hpp"

#include "client/files/output_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

namespace poolhall::client {
namespace {

constexpr std::size_t kMaxFileBytes = 64 * 1024;

/// A byte of the lock file stands for each token; byte 0 guards the list itself.
off_t lock_byte(std::string_view token) {
    constexpr std::size_t kBytes = std::size_t{1} << 30U;
    return static_cast<off_t>(1 + std::hash<std::string_view>{}(token) % kBytes);
}

bool lock(int file, off_t byte, short type, int command) {
    struct flock range {};

    range.l_type = type;
    range.l_whence = SEEK_SET;
    range.l_start = byte;
    range.l_len = 1;
    return ::fcntl(file, command, &range) == 0;
}

std::string field(const nlohmann::json& entry, const char* name) {
    const auto found = entry.find(name);
    return found != entry.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

/// Holds the list against other processes while it is read, changed and written.
class TokenStore::FileGuard {
  public:
    explicit FileGuard(int file) : file_(file) { lock(file_, 0, F_WRLCK, F_OFD_SETLKW); }

    ~FileGuard() { lock(file_, 0, F_UNLCK, F_OFD_SETLK); }

    FileGuard(const FileGuard&) = delete;
    FileGuard& operator=(const FileGuard&) = delete;

  private:
    int file_;
};

TokenStore::TokenStore(const std::filesystem::path& folder) : file_(folder / "tokens.json") {
    std::error_code ignored;  // what could not be made cannot be opened either
    if (std::filesystem::create_directories(folder, ignored)) ::chmod(folder.c_str(), 0700);
    lock_file_ = ::open((folder / "tokens.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
}

TokenStore::~TokenStore() {
    if (lock_file_ >= 0) ::close(lock_file_);
}

std::optional<std::string> TokenStore::claim(std::string_view server, std::string_view code) {
    const FileGuard guard(lock_file_);
    const auto entries = read();
    const auto newest = std::find_if(entries.rbegin(), entries.rend(), [&](const Entry& entry) {
        return entry.server == server && entry.code == code && lock_token(entry.token);
    });
    return newest == entries.rend() ? std::nullopt : std::optional(newest->token);
}

void TokenStore::keep(std::string_view server, std::string_view code, std::string_view token) {
    const FileGuard guard(lock_file_);
    auto entries = read();
    std::erase_if(entries, [&](const Entry& entry) { return entry.token == token; });
    entries.push_back({std::string(server), std::string(code), std::string(token)});
    if (entries.size() > kMaxTokens) entries.erase(entries.begin(), entries.end() - kMaxTokens);
    static_cast<void>(lock_token(token));  // a token just given is nobody else's
    unsaved_ = entries;
    write(entries);
}

void TokenStore::forget(std::string_view token) {
    const FileGuard guard(lock_file_);
    auto entries = read();
    std::erase_if(entries, [&](const Entry& entry) { return entry.token == token; });
    unsaved_ = entries;
    write(entries);
    lock(lock_file_, lock_byte(token), F_UNLCK, F_OFD_SETLK);
}

std::vector<TokenStore::Entry> TokenStore::read() const {
    std::ifstream in(file_, std::ios::binary);
    if (!in) return unsaved_;
    std::string text(kMaxFileBytes, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    // A damaged list costs the way back to a seat, never the program.
    const auto json = nlohmann::json::parse(text, nullptr, false);
    std::vector<Entry> entries;
    if (!json.is_array()) return entries;
    for (const auto& entry : json) {
        if (!entry.is_object() || field(entry, "token").empty()) continue;
        entries.push_back({field(entry, "server"), field(entry, "code"), field(entry, "token")});
    }
    return entries;
}

void TokenStore::write(const std::vector<Entry>& entries) const {
    auto json = nlohmann::json::array();
    for (const Entry& entry : entries) {
        json.push_back({{"server", entry.server}, {"code", entry.code}, {"token", entry.token}});
    }
    // Without the file the tokens last as long as the process: a fault is no reason to stop.
    files::OutputFile output(file_, files::OutputFile::Readers::kOwnerOnly);
    output.stream() << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
    output.finish();
}

bool TokenStore::lock_token(std::string_view token) const {
    return lock_file_ < 0 || lock(lock_file_, lock_byte(token), F_WRLCK, F_OFD_SETLK);
}

std::filesystem::path default_state_folder() {
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && state[0] == '/') return std::filesystem::path(state) / "poolhall";
    const char* home = std::getenv("HOME");
    return std::filesystem::path(home != nullptr ? home : "/tmp") / ".local/state/poolhall";
}

}  // namespace poolhall::client
