#pragma once

#include "shared/enum_names.hpp"
#include "shared/math/vec2.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// What players decide. A move is one value, the same in a program, on the wire and in the log;
// kType is its "type" there.
namespace poolhall {

/// How the player wants the cue ball struck. Directions and offsets are those of Strike.
struct Stroke {
    Vec2 direction{1, 0};            ///< of any length but zero
    std::optional<Real> speed = {};  ///< of the ball right after it, m/s; none: the game's own
    Vec2 offset = {};                ///< of the tip, [right, up], in radii of the ball
    Real elevation = 0;              ///< slope of the cue

    friend bool operator==(const Stroke&, const Stroke&) = default;
};

struct Shoot {
    static constexpr std::string_view kType = "shoot";
    Stroke strike;

    friend bool operator==(const Shoot&, const Shoot&) = default;
};

/// Puts the cue ball in hand on the table; the same seat goes on.
struct Place {
    static constexpr std::string_view kType = "place";
    Vec2 position;  ///< of its centre, m

    friend bool operator==(const Place&, const Place&) = default;
};

/// Gives the game to the other seat; in its own turn or not.
struct Concede {
    static constexpr std::string_view kType = "concede";

    friend bool operator==(const Concede&, const Concede&) = default;
};

/// What both seats have to want.
enum class Accord : std::uint8_t {
    kRematch,  ///< another game, once one is over
};

constexpr auto enum_names(Accord /*type*/) {
    return names_of<Accord>({{Accord::kRematch, "rematch"}});
}

/// One seat's consent; the other's brings it about.
struct Agree {
    static constexpr std::string_view kType = "agree";
    Accord what = Accord::kRematch;

    friend bool operator==(const Agree&, const Agree&) = default;
};

/// The shot clock has run down. Made by whoever keeps the match, never by a player.
struct TimeOut {
    static constexpr std::string_view kType = "time_out";

    friend bool operator==(const TimeOut&, const TimeOut&) = default;
};

/// The list of moves.
using Move = std::variant<Shoot, Place, Concede, Agree, TimeOut>;

}  // namespace poolhall
