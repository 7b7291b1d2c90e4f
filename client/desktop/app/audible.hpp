#pragma once

#include "client/desktop/app/table_controller.hpp"
#include "client/desktop/audio/sounds.hpp"

#include <optional>

namespace poolhall::client {

/// One sound, as Sounds::play takes it.
struct Audible {
    Sound sound = Sound::kCue;
    double strength = 0;  ///< 0 to 1
    double pan = 0;       ///< -1 left to 1 right
};

/// What is heard of it: clicks by the relative speed along the line of centres, rails by the speed
/// towards them, all of it where it happens along the table. Nothing for a ball that comes to rest.
[[nodiscard]] std::optional<Audible> audible(const TableSound& sound, const Table& table);

}  // namespace poolhall::client
