#pragma once

#include "shared/game/game_state.hpp"
#include "shared/game/move.hpp"
#include "shared/physics/motion/cue.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace poolhall {

/// Where the centre of a ball may be put: a rectangle along the rails, edges included, which may be
/// as thin as a line; m.
struct Region {
    Vec2 low;
    Vec2 high;

    friend bool operator==(const Region&, const Region&) = default;
};

/// What a shot may ask of the cue.
struct StrokeBounds {
    Real min_speed = 0;               ///< m/s
    Real max_speed = 0;               ///< m/s
    Real own_speed = 0;               ///< of a stroke that names none, m/s
    Real max_offset = kMiscueOffset;  ///< of the tip from the ball's middle, radii
    Real max_elevation = 0;           ///< slope of the cue

    friend bool operator==(const StrokeBounds&, const StrokeBounds&) = default;
};

/// Who may do what now. Clients, robots and servers read this and no rule besides. A seat may
/// concede as long as the game is not over, and agree to a rematch once it is.
struct Legal {
    Seat seat;                          ///< whose turn it is
    std::optional<Region> place;        ///< where the cue ball may be put; none: it stays
    std::optional<StrokeBounds> shoot;  ///< none: no shot now
    Vec2 aim{1, 0};  ///< a direction to begin aiming from, of any length but zero

    friend bool operator==(const Legal&, const Legal&) = default;
};

/// Why the rules refuse a move.
enum class Illegal : std::uint8_t {
    kNotOffered,    ///< no such move now
    kOutOfRegion,   ///< not a place where the cue ball may be put
    kBadDirection,  ///< zero or not finite
    kOutOfBounds,   ///< asks for more of the cue than the game allows
};

constexpr auto enum_names(Illegal /*type*/) {
    return names_of<Illegal>({{Illegal::kNotOffered, "not_offered"},
                              {Illegal::kOutOfRegion, "out_of_region"},
                              {Illegal::kBadDirection, "bad_direction"},
                              {Illegal::kOutOfBounds, "out_of_bounds"}});
}

struct IllegalMove {
    Illegal code = Illegal::kNotOffered;
    std::string_view field;  ///< JSON pointer into the move: "/strike/speed"; empty for the whole

    friend bool operator==(const IllegalMove&, const IllegalMove&) = default;
};

/// The nearest place to `position` that the region has.
[[nodiscard]] Vec2 nearest_place(const Region& region, Vec2 position);

/// What is wrong with the move, made by the seat whose turn it is; nothing if it may be played.
[[nodiscard]] std::optional<IllegalMove> find_fault(const Legal& legal, const Move& move);

/// The legal move with what it left open filled in, and with a place that rounding has taken out of
/// the region put back: as it is played and logged.
[[nodiscard]] Move completed(const Legal& legal, Move move);

}  // namespace poolhall
