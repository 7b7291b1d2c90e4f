#pragma once

#include <algorithm>
#include <chrono>

namespace poolhall::server {

/// Credits of one session: every message costs one, they come back at a steady rate up to a burst.
class RateCredit {
  public:
    using Clock = std::chrono::steady_clock;

    static constexpr double kPerSecond = 60;
    static constexpr double kBurst = 120;

    explicit RateCredit(Clock::time_point now) : last_(now) {}

    /// False if there is no credit left.
    [[nodiscard]] bool spend(Clock::time_point now) {
        const double elapsed = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        credit_ = std::min(kBurst, credit_ + elapsed * kPerSecond);
        if (credit_ < 1) return false;
        credit_ -= 1;
        return true;
    }

  private:
    double credit_ = kBurst;
    Clock::time_point last_;
};

}  // namespace poolhall::server
