#pragma once

#include "client/play/client_match.hpp"

namespace poolhall::client {

/// Moving the cue ball in hand by a pointer, a mouse or a finger: taken up, dragged, let go.
class Placing {
  public:
    explicit Placing(ClientMatch& match) : match_(match) {}

    /// The pointer goes down at `r`, m. True if it takes up the cue ball: it is in hand, of a seat
    /// here, and under the pointer.
    bool take_up(Vec2 r);

    [[nodiscard]] bool dragging() const { return dragging_; }

    /// The ball follows to `r`, m, as far as it may.
    void drag(Vec2 r);

    void let_go() { dragging_ = false; }

  private:
    ClientMatch& match_;
    bool dragging_ = false;
};

}  // namespace poolhall::client
