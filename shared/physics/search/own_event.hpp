#pragma once

#include "shared/physics/motion/arc.hpp"
#include "shared/table/table.hpp"

#include <array>
#include <cstdint>

namespace poolhall {

/// What a ball comes to by itself, other balls apart.
struct OwnEvent {
    enum class Kind : std::uint8_t { kTransition, kRail, kCapture };

    struct Touch {
        Rail rail = Rail::kNorth;
        Vec2 normal;  ///< unit, into the rubber
    };

    Real t = kNever;  ///< s, by the solver's clock
    Kind kind = Kind::kTransition;
    Pocket pocket = Pocket::kNorthWest;
    std::uint8_t touch_count = 0;
    std::array<Touch, 2> touches;  ///< both rails of a corner at once
};

}  // namespace poolhall
