#include "client/lab/run/bench_clock.hpp"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace poolhall::lab {

InstructionCounter::InstructionCounter() {
    perf_event_attr wanted{};
    wanted.type = PERF_TYPE_HARDWARE;
    wanted.size = sizeof(wanted);
    wanted.config = PERF_COUNT_HW_INSTRUCTIONS;
    wanted.exclude_kernel = 1;
    wanted.exclude_hv = 1;
    constexpr int kThisThread = 0;
    constexpr int kAnyProcessor = -1;
    constexpr int kNoGroup = -1;
    file_ = static_cast<int>(syscall(SYS_perf_event_open, &wanted, kThisThread, kAnyProcessor,
                                     kNoGroup, PERF_FLAG_FD_CLOEXEC));
}

InstructionCounter::~InstructionCounter() {
    if (file_ >= 0) close(file_);
}

std::optional<std::uint64_t> InstructionCounter::count() const {
    std::uint64_t value = 0;
    if (file_ < 0 || read(file_, &value, sizeof(value)) != sizeof(value)) return std::nullopt;
    return value;
}

}  // namespace poolhall::lab
