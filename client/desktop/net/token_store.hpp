#pragma once

#include "client/play/token_keeper.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poolhall::client {

/// The tokens that bring this person back to seats after a lost connection, a closed window or a
/// crash.
///
/// They lie in `folder`/tokens.json (mode 0600). A token in use is claimed by a lock that the
/// system drops when the process ends, however it ends; so two clients on one machine never come
/// back to the same seat. When the folder cannot be written, tokens last as long as the process.
class TokenStore : public TokenKeeper {
  public:
    explicit TokenStore(const std::filesystem::path& folder);
    ~TokenStore() override;

    static constexpr std::size_t kMaxTokens = 64;  ///< older ones are forgotten

    [[nodiscard]] std::optional<std::string> claim(std::string_view server,
                                                   std::string_view code) override;
    void keep(std::string_view server, std::string_view code, std::string_view token) override;
    void forget(std::string_view token) override;

  private:
    struct Entry {
        std::string server;
        std::string code;
        std::string token;
    };
    class FileGuard;

    [[nodiscard]] std::vector<Entry> read() const;
    void write(const std::vector<Entry>& entries) const;
    [[nodiscard]] bool lock_token(std::string_view token) const;

    std::filesystem::path file_;
    int lock_file_ = -1;          ///< open for the life of the process; -1 when it cannot be
    std::vector<Entry> unsaved_;  ///< used in place of the file when there is none
};

/// $XDG_STATE_HOME/poolhall, or ~/.local/state/poolhall.
[[nodiscard]] std::filesystem::path default_state_folder();

}  // namespace poolhall::client
