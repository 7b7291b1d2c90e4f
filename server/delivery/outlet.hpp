#pragma once

#include "protocol/encoding.hpp"
#include "protocol/messages.hpp"
#include "server/delivery/parcel.hpp"
#include "server/net/loop.hpp"
#include "server/room/match.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace poolhall::server {

class Room;

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

/// One connection, as rooms know it.
struct Member {
    MemberId id;
    Loop* loop = nullptr;  ///< the connection's
    std::shared_ptr<Outlet> outlet;
    protocol::Encoding encoding = protocol::Encoding::kJson;
};

/// What became of a member by its last command.
struct Standing {
    std::shared_ptr<Room> room;  ///< null: in no match
    bool seated = false;
};

/// A command on its way to a room. `done` is called once, on any thread, when it has been answered;
/// until then the connection sends no other, so that none of them need be queued without a bound.
struct Request {
    Member member;
    protocol::ClientMessage message;
    std::function<void(Standing)> done;
};

}  // namespace poolhall::server
