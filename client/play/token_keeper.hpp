#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace poolhall::client {

/// Keeps the tokens that bring this person back to seats after a lost connection or a new start.
/// `server` is any name that stays the same for one server.
class TokenKeeper {
  public:
    TokenKeeper() = default;
    TokenKeeper(const TokenKeeper&) = delete;
    TokenKeeper& operator=(const TokenKeeper&) = delete;
    virtual ~TokenKeeper() = default;

    /// The newest token for the match that no other client here uses; it is this one's from now on.
    [[nodiscard]] virtual std::optional<std::string> claim(std::string_view server,
                                                           std::string_view code) = 0;
    /// Keeps a token that the server gave, and claims it.
    virtual void keep(std::string_view server, std::string_view code, std::string_view token) = 0;
    /// The server does not know it any more.
    virtual void forget(std::string_view token) = 0;
};

}  // namespace poolhall::client
