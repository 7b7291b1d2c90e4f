#pragma once

#include "server/delivery/parcel.hpp"

#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>

namespace poolhall::server {

/// What waits to be written to one session, bounded by this policy:
///
/// - Up to kBacklog messages wait as they are.
/// - Past that, the session skips to the newest state: a frame is merged into one of its shot that
///   waits (newest positions, the events of both, so that no collision mark is lost); an aim or a
///   table replaces one that waits; when a new shot starts, a whole shot that waits shrinks to the
///   table after it.
/// - Replies are never dropped, and a session that lets kLimit messages pile up is not reading at
///   all: push() says so, and its owner ends it.
class Outbox {
  public:
    using Clock = std::chrono::steady_clock;

    static constexpr std::size_t kBacklog = 8;
    static constexpr std::size_t kLimit = 256;

    /// False if the outbox is full; the session must then be ended.
    [[nodiscard]] bool push(Parcel parcel, Clock::time_point now);
    /// The next message to write, if there is one.
    [[nodiscard]] std::optional<Parcel> pop();

    void clear();

    [[nodiscard]] bool empty() const { return waiting_.empty(); }

    [[nodiscard]] std::size_t size() const { return waiting_.size(); }

    /// For how long the session has been behind: messages were merged or dropped, and it has not
    /// read everything since.
    [[nodiscard]] Clock::duration lag(Clock::time_point now) const {
        return behind_since_ ? now - *behind_since_ : Clock::duration::zero();
    }

  private:
    bool merge_frame(const Parcel& parcel);
    void drop_older(const Parcel& parcel);
    void shrink_shot();

    std::deque<Parcel> waiting_;
    std::optional<Clock::time_point> behind_since_;
};

}  // namespace poolhall::server
