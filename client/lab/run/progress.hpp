#pragma once

#include <cstddef>
#include <ostream>
#include <string>

namespace poolhall::lab {

/// Ctrl-C asks for an end instead of ending the program, as long as this lives.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    [[nodiscard]] static bool asked_for();

  private:
    void (*before_)(int);
};

/// A bar that shows how far a long run is, on one line of a terminal that is written again and
/// again.
class Progress {
  public:
    /// Shows nothing unless `visible`.
    Progress(std::ostream& out, bool visible) : out_(out), visible_(visible) {}

    /// Another part of the run, of so many steps.
    void begin(const std::string& part, std::size_t steps);
    void step();
    /// Takes the bar away, so that other text can be written.
    void clear();

  private:
    void draw();

    std::ostream& out_;
    bool visible_;
    std::string part_;
    std::size_t steps_ = 0;
    std::size_t done_ = 0;
    std::size_t shown_ = 0;  ///< per cent
};

}  // namespace poolhall::lab
