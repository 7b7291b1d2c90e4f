#pragma once

#include "shared/physics/effects/prospect.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poolhall::analysis {

/// What an effect that the scene names has to do with one shot of it.
struct EffectUse {
    std::string effect;              ///< "sliding"; "throw", a model of impacts, is one of them
    std::optional<Bound> ruled_out;  ///< why it could not act; nothing if the shot called for it
    bool acted = false;              ///< an event of the shot shows it

    friend bool operator==(const EffectUse&, const EffectUse&) = default;
};

/// Of all effects that the scene names, in the order of NamedEffects. The trace must be the
/// scene's.
[[nodiscard]] std::vector<EffectUse> effect_uses(const Scene& scene, const ShotTrace& trace);

/// "called for: sliding, rolling, throw. Ruled out: jump (level cue), pockets (no ball reaches
/// one)"; of those called for that did not act "(idle)". Empty if nothing is named.
[[nodiscard]] std::string in_words(const std::vector<EffectUse>& uses);

}  // namespace poolhall::analysis
