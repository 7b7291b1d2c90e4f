#pragma once

#include <sys/types.h>

namespace poolhall::load {

/// CPU time of all threads of a process, s; from the scheduler's own count, in ns.
[[nodiscard]] double cpu_seconds(pid_t process);
/// Resident memory, bytes.
[[nodiscard]] double resident_bytes(pid_t process);

}  // namespace poolhall::load
