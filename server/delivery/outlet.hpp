#pragma once

#include "server/delivery/parcel.hpp"

#include <cstdint>
#include <string>

namespace poolhall::server {

/// Why a session ends; the WebSocket close code says so too.
enum class CloseReason : std::uint16_t {
    kNormal = 1000,
    kGoingAway = 1001,    ///< the server shuts down
    kUnsupported = 1003,  ///< text on CBOR or binary on JSON
    kPolicy = 1008,       ///< too fast, too slow, or replaced by a newer connection
};

/// Where the messages for one connection go. Used on the connection's own loop only.
class Outlet {
  public:
    Outlet() = default;
    virtual ~Outlet() = default;
    Outlet(const Outlet&) = delete;
    Outlet& operator=(const Outlet&) = delete;
    Outlet(Outlet&&) = delete;
    Outlet& operator=(Outlet&&) = delete;

    virtual void push(Parcel parcel) = 0;
    /// Sends `closing` with the sentence, then closes.
    virtual void close(CloseReason reason, const std::string& sentence) = 0;
    /// Drops the connection without a word.
    virtual void abort() = 0;
};

}  // namespace poolhall::server
