#pragma once

#include "shared/enum_names.hpp"
#include "shared/physics/effects/all_effects.hpp"

#include <cstdint>

namespace poolhall {

/// A cloth with the rails and balls that go with it: all effects of a real table. presets.cpp has
/// the numbers and shared/PHYSICS.md ("Presets") their sources.
enum class EffectsPreset : std::uint8_t {
    kBar,
    kWorsted,  ///< as in tournaments of pool
    kSnooker,
    kHeatedCarom,
};

constexpr auto enum_names(EffectsPreset /*type*/) {
    return names_of<EffectsPreset>({{EffectsPreset::kBar, "bar"},
                                    {EffectsPreset::kWorsted, "worsted"},
                                    {EffectsPreset::kSnooker, "snooker"},
                                    {EffectsPreset::kHeatedCarom, "heated_carom"}});
}

[[nodiscard]] Effects preset_value(EffectsPreset preset);

}  // namespace poolhall
