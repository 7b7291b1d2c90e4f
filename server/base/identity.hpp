#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>

namespace poolhall::server {

/// Program and version, as `welcome` and replays carry it.
inline constexpr std::string_view kServerName = "poolhall " POOLHALL_VERSION;

/// Unix time, ms.
inline std::int64_t unix_ms() {
    using namespace std::chrono;
    return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace poolhall::server
