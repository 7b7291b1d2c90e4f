#pragma once

#include "shared/enum_names.hpp"
#include "shared/table/ball.hpp"
#include "shared/table/table.hpp"

#include <cstdint>
#include <optional>

// Tables and balls as they are made, by name. presets.cpp has the numbers, a row each, and
// shared/PHYSICS.md ("Presets") their sources.
namespace poolhall {

enum class TablePreset : std::uint8_t {
    kNineFoot,
    kNineFootPro,  ///< with tight mouths
    kEightFoot,
    kEightFootHome,
    kSevenFootBar,
    kTwelveFootSnooker,
    kTenFootCarom,
};

constexpr auto enum_names(TablePreset /*type*/) {
    return names_of<TablePreset>({{TablePreset::kNineFoot, "9ft"},
                                  {TablePreset::kNineFootPro, "9ft_pro"},
                                  {TablePreset::kEightFoot, "8ft"},
                                  {TablePreset::kEightFootHome, "8ft_home"},
                                  {TablePreset::kSevenFootBar, "7ft_bar"},
                                  {TablePreset::kTwelveFootSnooker, "12ft_snooker"},
                                  {TablePreset::kTenFootCarom, "10ft_carom"}});
}

enum class BallSet : std::uint8_t {
    kWpa,
    kBarHeavy,  ///< a coin table that tells the cue ball by its weight
    kBarLarge,  ///< or by its size
    kSnooker,
    kCarom,
};

constexpr auto enum_names(BallSet /*type*/) {
    return names_of<BallSet>({{BallSet::kWpa, "wpa"},
                              {BallSet::kBarHeavy, "bar_heavy"},
                              {BallSet::kBarLarge, "bar_large"},
                              {BallSet::kSnooker, "snooker"},
                              {BallSet::kCarom, "carom"}});
}

[[nodiscard]] Table preset_value(TablePreset preset);

/// The balls of a set but for a cue ball of its own.
[[nodiscard]] BallSpec preset_value(BallSet set);

/// The set's cue ball, where it differs from the others.
[[nodiscard]] std::optional<BallSpec> cue_ball_of(BallSet set);

}  // namespace poolhall
