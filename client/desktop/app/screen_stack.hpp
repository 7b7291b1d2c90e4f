#pragma once

#include "client/desktop/app/screen.hpp"

#include <memory>
#include <vector>

namespace poolhall::client {

/// The screens in the window. Events come to the uppermost first, pictures begin with the lowest.
class ScreenStack {
  public:
    void push(std::unique_ptr<Screen> screen);

    /// False if no screen has taken it.
    bool handle(const ScreenEvent& event);
    void update(double dt, double now);
    void draw(const Frame& frame);

    [[nodiscard]] bool moves() const;
    /// Rises whenever they would look different.
    [[nodiscard]] std::uint64_t revision() const;
    [[nodiscard]] double due_in(double now) const;
    [[nodiscard]] std::string title() const;
    void show_status(const std::string& line);

  private:
    std::vector<std::unique_ptr<Screen>> screens_;  ///< from the lowest up
    std::uint64_t changes_ = 0;  ///< screens that came and went, and what those had changed
};

}  // namespace poolhall::client
