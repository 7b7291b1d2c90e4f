#pragma once

#include <boost/chrono/thread_clock.hpp>

namespace poolhall::compare {

/// CPU time of this thread, ns.
[[nodiscard]] inline double cpu_time_ns() {
    return static_cast<double>(boost::chrono::thread_clock::now().time_since_epoch().count());
}

}  // namespace poolhall::compare
