#include "client/compare/cpu_time.hpp"

#include <ctime>

namespace poolhall::compare {

double cpu_time_ns() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

}  // namespace poolhall::compare
