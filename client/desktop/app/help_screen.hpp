#pragma once

#include "client/desktop/app/screen.hpp"

namespace poolhall::client {

/// What the keys and the mouse do. The table goes on under it, but the mouse and Space are the
/// help's: they close it.
class HelpScreen : public Screen {
  public:
    Answer handle(const ScreenEvent& event) override;
    void draw(const Frame& frame) override;
};

}  // namespace poolhall::client
