#pragma once

#include <chrono>

namespace poolhall::client {

/// The client's clock: s since some fixed moment, never falling.
inline double clock_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace poolhall::client
