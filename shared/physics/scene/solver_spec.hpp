#pragma once

#include "shared/enum_names.hpp"
#include "shared/fields.hpp"
#include "shared/math/real.hpp"

#include <cstdint>
#include <tuple>

namespace poolhall {

/// Which solver simulates a shot. solvers/solvers.cpp has what each is.
enum class SolverKind : std::uint8_t {
    kEuler,    ///< explicit Euler, contacts by swept time of impact
    kOverlap,  ///< explicit Euler, contacts by the overlap found at the end of a tick; it misses
               ///< some
    kSemiImplicit,  ///< semi-implicit Euler: velocities before places
    kExactArc,      ///< closed-form motion inside each tick, contacts on its chord
    kEvent,         ///< closed-form motion from event to event; no tick at all
};

constexpr auto enum_names(SolverKind /*type*/) {
    return names_of<SolverKind>({{SolverKind::kEuler, "euler"},
                                 {SolverKind::kOverlap, "overlap"},
                                 {SolverKind::kSemiImplicit, "semi_implicit"},
                                 {SolverKind::kExactArc, "exact_arc"},
                                 {SolverKind::kEvent, "event"}});
}

inline constexpr double kMinSolverHz = 1;
inline constexpr double kMaxSolverHz = 1e6;

struct SolverSpec {
    SolverKind kind = SolverKind::kEuler;
    Real hz = 30;  ///< ticks a second; not used by a solver without ticks

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("kind", &SolverSpec::kind),
            fields::of("hz", &SolverSpec::hz, {kMinSolverHz, kMaxSolverHz}).in("1/s").or_default()};
    }

    friend constexpr bool operator==(const SolverSpec&, const SolverSpec&) = default;
};

}  // namespace poolhall
