#pragma once

#include "client/lab/effects/callgrind.hpp"
#include "client/lab/effects/effects_results.hpp"
#include "client/lab/run/bench_clock.hpp"
#include "shared/physics/scene/scene.hpp"

#include <string_view>
#include <vector>

namespace poolhall::lab {

/// What the shots cost, all of them by turns. Instructions are counted by `callgrind`, or where it
/// is null by the processor, if that can.
[[nodiscard]] ShotPrices prices_of(std::vector<Scene> shots, const Repeats& repeats,
                                   Callgrind* callgrind);

/// What a shot costs by its own solver, as simulate() does it.
[[nodiscard]] Price price_of(const std::vector<Scene>& shots, const Repeats& repeats);

/// What a shot costs by the event solver in the kernel of that name, which must cover them all.
[[nodiscard]] Price price_by(std::string_view kernel, const std::vector<Scene>& shots,
                             const Repeats& repeats);

}  // namespace poolhall::lab
