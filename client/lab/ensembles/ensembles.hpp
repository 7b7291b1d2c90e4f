#pragma once

#include "client/lab/corpora/random.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

// Shots of one kind each, on which solvers are measured.
namespace poolhall::lab {

/// Where a shot's true course is known from.
enum class ReferenceKind {
    kEventIn113Bits,  ///< client/lab/reference
    kUnfolding,       ///< client/lab/ensembles/unfolding.hpp
};

/// What decides a shot.
enum class WinnerRule {
    kNone,
    kFirstPocketed,  ///< the ball that goes down first
    kEndGame,        ///< the rules of the end game: who has won after the shot, if anybody
};

struct Ensemble {
    std::string_view name;   ///< "two_balls"
    std::string_view title;  ///< for people
    Scene (*make)(Random& random);
    std::size_t shots;        ///< of a full run
    std::size_t quick_shots;  ///< of a quick one
    double sample_hz;         ///< for the error within a shot
    ReferenceKind reference = ReferenceKind::kEventIn113Bits;
    WinnerRule winner = WinnerRule::kNone;
    int quick_max_hz = 1920;  ///< the highest rate of a quick run
};

[[nodiscard]] std::span<const Ensemble> ensembles();
/// Nothing if there is none of that name.
[[nodiscard]] const Ensemble* find_ensemble(std::string_view name);

/// The first `count` scenes of the ensemble for a seed, their solver kEvent: the same on every
/// machine, whatever other ensembles are run.
[[nodiscard]] std::vector<Scene> scenes_of(const Ensemble& ensemble, std::uint64_t seed,
                                           std::size_t count);

/// Who or what has won the ensemble's shot, as a number that differs where the winners do; nothing
/// if nobody has, or nobody can.
[[nodiscard]] std::optional<int> winner_of(const Ensemble& ensemble, const Scene& scene,
                                           const ShotTrace& trace);

}  // namespace poolhall::lab
