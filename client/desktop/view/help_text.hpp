#pragma once

#include <array>
#include <string_view>

namespace poolhall::client {

struct KeyRow {
    std::string_view key;
    std::string_view action;
};

/// What the keys and the mouse do: the help screen shows it, and README's table is compared with
/// it.
inline constexpr std::array kKeyTable{
    KeyRow{"Space", "Shoot; take a step in step mode; play again after a game"},
    KeyRow{"Left, Right", "Turn the aim"},
    KeyRow{"Page Up, Page Down", "Turn the aim fast"},
    KeyRow{"Up, Down", "Move the cue ball on the base line before the first shot"},
    KeyRow{"F1", "Show or hide this help"},
    KeyRow{"F2", "Show or hide the frame rate, the solver, and what the shot called for"},
    KeyRow{"F3", "Step mode: Space moves on by 1/30 s, rings show the way"},
    KeyRow{"F4", "Collision mode: yellow circles where balls hit something"},
    KeyRow{"F5", "The last shot by other solvers, with cost and distance; again for more"},
    KeyRow{"H", "Play both seats, or give the other seat back"},
    KeyRow{"C", "Copy the join code"},
    KeyRow{"M", "Sound off or on"},
    KeyRow{"P", "Save a screenshot"},
    KeyRow{"Esc", "Exit"},
    KeyRow{"Mouse", "Move to aim, click to shoot, drag the cue ball"},
};

}  // namespace poolhall::client
