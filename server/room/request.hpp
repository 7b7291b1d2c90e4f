#pragma once

#include "protocol/messages.hpp"
#include "server/base/counters.hpp"
#include "server/delivery/shards.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace poolhall::server {

class Room;

/// Why a command is not carried out; what the client gets as a `reject`.
struct Refusal {
    protocol::RejectCode code = protocol::RejectCode::kIllegal;
    std::string reason;  ///< a sentence
};

/// Where a member stands between two commands.
struct Standing {
    std::shared_ptr<Room> room;  ///< null: in no match
    bool seated = false;
};

struct RequestSpec {
    Shards& shards;
    Counters& counters;
    Member member;
    std::uint32_t seq = 0;  ///< of the command
    Standing standing;      ///< of the member so far
    /// Called once, on any thread, when the command has been answered; until then the connection
    /// sends no other, so that none of them need be queued without a bound.
    std::function<void(Standing)> done;
};

/// The right and the duty to answer one command. Each answer uses the request up; one that is
/// dropped without is a bug, which stops a debug build. A release build rejects the command, so
/// that the connection does not wait forever.
class [[nodiscard]] Request {
  public:
    explicit Request(RequestSpec spec);
    ~Request();
    Request(Request&& other) noexcept;
    Request(const Request&) = delete;
    Request& operator=(const Request&) = delete;
    Request& operator=(Request&&) = delete;

    [[nodiscard]] const Member& member() const { return spec_.member; }

    /// Where the member stood when it asked.
    [[nodiscard]] const Standing& standing() const { return spec_.standing; }

    /// The command has been carried out.
    void accept(Standing now) &&;
    /// So it has, and the answer is `joined`, whose seq is filled in here.
    void join(protocol::Joined joined, Standing now) &&;
    /// It has not, and has changed nothing.
    void reject(Refusal refusal) &&;

  private:
    void finish(const protocol::ServerMessage& answer, Standing now);

    RequestSpec spec_;
    bool open_ = true;
};

}  // namespace poolhall::server
