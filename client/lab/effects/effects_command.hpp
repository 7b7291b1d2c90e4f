#pragma once

#include "client/lab/bench_clock.hpp"
#include "client/lab/status.hpp"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>

namespace poolhall::lab {

struct EffectsOptions {
    std::uint64_t seed = 1;
    bool quick = false;
    std::size_t shots = 0;  ///< of each kernel and effect; 0: 200, or 20 if quick
    std::string out;        ///< folder; empty: only the tables are printed
    bool bar = false;       ///< show how far it is, on `error`

    [[nodiscard]] Repeats repeats() const { return quick ? Repeats{3, 2e6} : Repeats{7, 2e7}; }
};

/// Measures what every kernel and every effect costs, and how far each effect moves the outcome;
/// checks first that shots without an effect and with it at zero strength are the same. Ctrl-C
/// keeps what is finished.
[[nodiscard]] Status measure_effects(const EffectsOptions& options, std::ostream& out,
                                     std::ostream& error);

}  // namespace poolhall::lab
