#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>

namespace poolhall::server {

/// Program and version, as `welcome` and replays carry it.
inline constexpr std::string_view kServerName = "poolhall " POOLHALL_VERSION;

/// Unix time, ms. It never goes back, nor jumps when somebody sets the system's clock: nobody's
/// time to play must run out by that.
inline std::int64_t unix_ms() {
    using namespace std::chrono;
    static const auto start = system_clock::now().time_since_epoch();
    static const auto start_steady = steady_clock::now();
    return duration_cast<milliseconds>(start + (steady_clock::now() - start_steady)).count();
}

}  // namespace poolhall::server
