#pragma once

#include "shared/physics/search/free_boxes.hpp"
#include "shared/table/table.hpp"

#include <cstddef>
#include <vector>

namespace poolhall {

/// Some of a shot's balls, in order. It has room for all, so that adding one is one store.
class BallList {
  public:
    /// Empties it, and makes room.
    void reset(std::size_t balls) {
        balls_.resize(balls);
        count_ = 0;
    }

    void clear() { count_ = 0; }

    void push_back(std::size_t ball) { balls_[count_++] = ball; }

    [[nodiscard]] bool empty() const { return count_ == 0; }

    [[nodiscard]] const std::size_t* begin() const { return balls_.data(); }

    [[nodiscard]] const std::size_t* end() const { return balls_.data() + count_; }

  private:
    std::vector<std::size_t> balls_;
    std::size_t count_ = 0;
};

/// How a ball's box is made.
struct BoxPlan {
    Vec2 clear;            ///< up to which |x| and |y| its centre meets nothing of the table, m
    Real ticks = 1;        ///< for how many ticks, if it has room
    bool is_alone = true;  ///< in the tick before
};

struct FoundCapture {
    std::size_t ball;
    Pocket pocket;
};

/// The memory of InstantSearch, and with it of the stepping solvers.
struct SteppingMemory {
    FreeBoxes boxes;
    BallList moving;         ///< balls in play that are not stationary, in order
    BallList loose;          ///< those that may meet something in this step, in order
    std::vector<Vec2> next;  ///< where a moving ball is at the step's end, m
    std::vector<BoxPlan> plans;
    // What happens first; contacts are in the workspace.
    std::vector<FoundCapture> captures;
    std::vector<std::size_t> transitions;  ///< balls
};

}  // namespace poolhall
