#pragma once

#include "shared/enum_names.hpp"
#include "shared/physics/search/box.hpp"

#include <cstdint>
#include <optional>

namespace poolhall {

/// Why an effect that a scene names cannot act in a shot.
enum class Bound : std::uint8_t {
    kNothingMoves,  ///< every ball is at rest, and stays so
    kLevelCue,      ///< no ball is in the air, the cue is level, and no impact lifts a ball
    kNoSideSpin,    ///< no ball spins about the vertical, and nothing can make it
    kNoMeeting,     ///< no two balls can meet
    kOutOfReach,    ///< no ball can get there
};

constexpr auto enum_names(Bound /*type*/) {
    return names_of<Bound>({{Bound::kNothingMoves, "nothing_moves"},
                            {Bound::kLevelCue, "level_cue"},
                            {Bound::kNoSideSpin, "no_side_spin"},
                            {Bound::kNoMeeting, "no_meeting"},
                            {Bound::kOutOfReach, "out_of_reach"}});
}

/// What may happen in a shot at all, as far as bounds can tell before it is simulated: false where
/// it cannot. Effects judge by it whether they can act (their `ruled_out`).
struct Prospect {
    bool moves = true;      ///< anything does
    bool flies = true;      ///< a ball may leave the cloth
    bool side_spin = true;  ///< a ball may spin about the vertical
    bool meets = true;      ///< two balls may meet
    bool rails = true;      ///< a ball may touch a rail
    /// Where the surfaces of balls that may move are from the first instant to the last, m.
    Box reach = Box::everything();
    bool reach_is_bounded = false;
    bool reach_is_by_energy = false;  ///< the bound is one that the trace has to confirm

    /// The nothing that a hook answers where the effect may act, or else the bound.
    [[nodiscard]] static constexpr std::optional<Bound> unless(bool may_act, Bound bound) {
        return may_act ? std::nullopt : std::optional(bound);
    }
};

}  // namespace poolhall
