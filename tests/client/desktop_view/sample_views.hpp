#pragma once

#include "client/play/view_state.hpp"

#include <SDL2/SDL_rect.h>

#include <string>
#include <vector>

// Pictures of every kind for the tests and for people to look at.
namespace poolhall::client::samples {

/// The start of a game between two players, the first to shoot.
[[nodiscard]] ViewState start();
/// Aimed so that the cue ball meets the 8-ball off its centre, with the prediction.
[[nodiscard]] ViewState aiming();

struct NamedView {
    std::string name;
    ViewState state;
    SDL_Point size{1280, 720};  ///< of the output, px
    bool help = false;          ///< the help lies over it
};

[[nodiscard]] std::vector<NamedView> all();

}  // namespace poolhall::client::samples
