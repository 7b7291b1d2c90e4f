#pragma once

namespace poolhall::compare {

/// CPU time of this thread, ns.
[[nodiscard]] double cpu_time_ns();

}  // namespace poolhall::compare
