#pragma once

#include <chrono>
#include <ctime>

namespace poolhall::server {

/// What this thread has spent on a processor since it began.
[[nodiscard]] inline std::chrono::nanoseconds cpu_time_of_thread() {
    timespec spent{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
    return std::chrono::seconds(spent.tv_sec) + std::chrono::nanoseconds(spent.tv_nsec);
}

}  // namespace poolhall::server
