#pragma once

#include "shared/physics/scene/trace.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// How far two simulations of one scene, by different solvers, tell the same story.
namespace poolhall::analysis {

/// Whether both tell of the same thing, at whatever time: same kind, same balls (of two, in either
/// order), same rail, same pocket.
[[nodiscard]] bool is_same_event(const ShotEvent& a, const ShotEvent& b);

/// Whether balls met each other or a rail.
[[nodiscard]] bool is_impact(const ShotEvent& event);

/// How far the events of `other` are those of `reference`.
struct Agreement {
    /// The common events before the first difference: places in the events of the reference (0, 1,
    /// 2, ...) and of the other.
    std::vector<std::pair<std::size_t, std::size_t>> matching;
    /// The first difference: an event of the reference that the other has not, or what the other
    /// has instead; one or both. None of them where the traces agree to their ends.
    std::optional<std::size_t> lacking;  ///< place in the reference's events
    std::optional<std::size_t> instead;  ///< place in the other's events
    /// Until when they agree: the time of the first difference, or of the reference's end; s.
    double horizon = 0;

    [[nodiscard]] bool complete() const { return !lacking && !instead; }
};

/// Goes through the reference's events in their order; each must be the next one in the other's for
/// every ball that takes part. So each ball's own sequence is compared: balls that have not met do
/// not care which of them stops first.
[[nodiscard]] Agreement agreement(const ShotTrace& reference, const ShotTrace& other);

/// The first difference in a sentence without a full stop, "at 0.512 s cue meets rail N, but not in
/// euler:30, where at 0.533 s cue hits 1 instead"; empty where there is none. The names say whose
/// traces they are.
[[nodiscard]] std::string first_difference(const Scene& scene, const Agreement& agreement,
                                           const ShotTrace& reference, const ShotTrace& other,
                                           const std::string& name_of_other);

/// An event in words: "cue hits 1", "1 drops into NE". The scene must be the trace's.
[[nodiscard]] std::string in_words(const Scene& scene, const ShotEvent& event);

/// How far apart each ball's last place is in both, m; a pocketed ball is where it was captured.
[[nodiscard]] std::vector<double> rest_distances(const ShotTrace& a, const ShotTrace& b);

/// The largest of them, m. The traces must have a ball.
[[nodiscard]] double farthest_at_rest(const ShotTrace& a, const ShotTrace& b);

/// Whether the same balls went down, into the same pockets, and the same left the table.
[[nodiscard]] bool is_same_verdict(const ShotTrace& a, const ShotTrace& b);

/// The first ball that went down, if any.
[[nodiscard]] std::optional<BallIndex> first_pocketed(const ShotTrace& trace);

/// Impacts between balls, counted pair by pair.
struct CollisionCounts {
    std::size_t missed = 0;    ///< in the reference, and not in the other
    std::size_t invented = 0;  ///< the other way round
};

/// In whatever order and at whatever time: a pair that meets twice in the reference and once in the
/// other misses one.
[[nodiscard]] CollisionCounts compare_collisions(const ShotTrace& reference,
                                                 const ShotTrace& other);

}  // namespace poolhall::analysis
