#pragma once

#include "client/lab/corpora/real_play.hpp"
#include "client/lab/effects/effects_results.hpp"
#include "client/lab/run/bench_clock.hpp"

#include <cstddef>
#include <cstdint>

namespace poolhall::lab {

/// The kind's first `count` shots for the seed: which effects they call for, and what it saves to
/// simulate no others.
[[nodiscard]] PlayRow measure_play(const PlayKind& kind, std::uint64_t seed, std::size_t count,
                                   const Repeats& repeats);

}  // namespace poolhall::lab
