#pragma once

#include <cstdint>

namespace poolhall::client {

/// How the client is connected to its match.
enum class Link : std::uint8_t { kOffline, kConnecting, kOnline, kLost };

}  // namespace poolhall::client
