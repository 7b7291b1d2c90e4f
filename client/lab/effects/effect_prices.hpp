#pragma once

#include "client/lab/bench_clock.hpp"
#include "client/lab/effects/effects_results.hpp"
#include "shared/physics/scene.hpp"

#include <string_view>
#include <vector>

namespace poolhall::lab {

/// What the shots cost, all of them by turns.
[[nodiscard]] ShotPrices prices_of(std::vector<Scene> shots, const Repeats& repeats);

/// What a shot costs by the event solver in the kernel of that name, which must cover them all.
[[nodiscard]] Price price_by(std::string_view kernel, const std::vector<Scene>& shots,
                             const Repeats& repeats);

}  // namespace poolhall::lab
