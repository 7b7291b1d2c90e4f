#pragma once

namespace poolhall::client {

/// Step mode: time stands still, and each press of a key lets a thirtieth of a second pass. When
/// nothing moves the same key shoots, so a press too many must not: after the last step it does
/// nothing until kPause has passed without one, then it leaves the end of the shot, and it shoots
/// only when as much has passed again.
class StepMode {
  public:
    static constexpr double kPause = 0.7;  ///< s

    void toggle();

    [[nodiscard]] bool on() const { return on_; }

    /// The key took a step, or began a new game, at `now` (s). `at_end`: that was the last step,
    /// and what it led to is now to be looked at.
    void looked(double now, bool at_end);
    /// Takes a press of the key at `now` (s) where there is no step to take. True if that was all
    /// that it does.
    bool takes(double now);

    void leave_end() { at_end_ = false; }

    /// The last step has been taken, and its end not been left yet.
    [[nodiscard]] bool at_end() const { return at_end_; }

  private:
    bool on_ = false;
    bool at_end_ = false;
    double last_look_ = -1e9;  ///< s
};

}  // namespace poolhall::client
