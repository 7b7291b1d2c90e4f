#pragma once

#include "server/base/shot_costs.hpp"

#include <atomic>
#include <cstdint>

namespace poolhall::server {

/// What the server counts; written from any thread, each by itself.
struct Counters {
    std::atomic<std::int64_t> connections{0};           ///< open, HTTP and WebSocket
    std::atomic<std::uint64_t> connections_refused{0};  ///< for want of a place
    std::atomic<std::uint64_t> connections_evicted{0};  ///< silent ones, closed for new ones
    std::atomic<std::int64_t> sessions{0};              ///< open WebSocket sessions
    std::atomic<std::int64_t> matches{0};               ///< open
    std::atomic<std::uint64_t> shots{0};
    std::atomic<std::uint64_t> messages_sent{0};
    std::atomic<std::uint64_t> bytes_sent{0};  ///< of messages, without WebSocket headers
    std::atomic<std::uint64_t> rejects{0};
    ShotCosts shot_costs;
};

}  // namespace poolhall::server
