#pragma once

#include "client/lab/corpora/random.hpp"
#include "shared/physics/scene/scene.hpp"

#include <span>
#include <string_view>

namespace poolhall::lab {

/// Shots of one kind as people play them, with every effect of a full table named: cloth, throw,
/// mouths, flight. By `event`, within the limits of a match.
struct PlayKind {
    std::string_view name;   ///< "safeties"
    std::string_view title;  ///< for people
    Scene (*make)(Random& random);
};

/// Breaks, run-outs, safeties, taps.
[[nodiscard]] std::span<const PlayKind> kinds_of_play();

}  // namespace poolhall::lab
