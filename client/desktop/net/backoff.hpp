#pragma once

#include <chrono>
#include <cstdint>
#include <random>

namespace poolhall::client {

/// Pauses between attempts to connect: doubling from 0.25 s to 8 s, each shortened at random by up
/// to half, so that a hall full of clients does not come back in one instant.
class Backoff {
  public:
    explicit Backoff(std::uint32_t seed) : random_(seed) {}

    static constexpr std::chrono::milliseconds kFirst{250};
    static constexpr std::chrono::milliseconds kLongest{8000};

    [[nodiscard]] std::chrono::milliseconds next();

    void reset() { longest_ = kFirst; }

  private:
    std::minstd_rand random_;
    std::chrono::milliseconds longest_ = kFirst;
};

}  // namespace poolhall::client
