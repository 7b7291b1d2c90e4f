#pragma once

#include <string_view>

namespace poolhall::client {

struct KeyRow {
    std::string_view key;
    std::string_view action;
};

/// What the keys and the mouse do: the help screen shows it, and README's table is compared with
/// it.
inline constexpr KeyRow kKeyTable[] = {
    {"Space", "Shoot; take a step in step mode; play again after a game"},
    {"Left, Right", "Turn the aim"},
    {"Page Up, Page Down", "Turn the aim fast"},
    {"Up, Down", "Move the cue ball on the base line before the first shot"},
    {"F1", "Show or hide this help"},
    {"F2", "Show or hide the frame rate"},
    {"F3", "Step mode: Space moves on by 1/30 s, rings show the way"},
    {"F4", "Collision mode: yellow circles where balls hit something"},
    {"H", "Play both seats, or give the other seat back"},
    {"C", "Copy the join code"},
    {"M", "Sound off or on"},
    {"P", "Save a screenshot"},
    {"Esc", "Exit"},
    {"Mouse", "Move to aim, click to shoot, drag the cue ball"},
};

}  // namespace poolhall::client
