#pragma once

#include "shared/enum_names.hpp"

#include <cstdint>

namespace poolhall {

/// What can happen in a shot. Values enter the trace's hash: new ones go to the end.
enum class EventKind : std::uint8_t {
    kStrike,
    kRollToRest,
    kBallBall,
    kBallRail,
    kBallPocket,
    kSlideToRoll,
    kSpinToRest,
    kBounce,    ///< on the slate
    kOffTable,  ///< over a rail
};

constexpr auto enum_names(EventKind /*type*/) {
    return names_of<EventKind>({{EventKind::kStrike, "strike"},
                                {EventKind::kRollToRest, "roll_to_rest"},
                                {EventKind::kBallBall, "ball_ball"},
                                {EventKind::kBallRail, "ball_rail"},
                                {EventKind::kBallPocket, "ball_pocket"},
                                {EventKind::kSlideToRoll, "slide_to_roll"},
                                {EventKind::kSpinToRest, "spin_to_rest"},
                                {EventKind::kBounce, "bounce"},
                                {EventKind::kOffTable, "off_table"}});
}

}  // namespace poolhall
