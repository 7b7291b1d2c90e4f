#pragma once

#include "shared/physics/scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

// Shots on which an effect, or a kernel, is measured.
namespace poolhall::lab {

using ChangeScene = void (*)(Scene& scene);

/// An effect and an ensemble whose shots call for it.
struct EffectCase {
    std::string_view effect;    ///< "sliding"
    std::string_view ensemble;  ///< of ensembles()
    ChangeScene present;        ///< makes the ensemble's shot call for the effect
    ChangeScene absent;         ///< leaves it out again
    ChangeScene zero;  ///< names it, without strength; null where it has no such coefficient
};

[[nodiscard]] std::span<const EffectCase> effect_cases();

/// Shots that call for all of a kernel's effects and for no other: simulate() takes this kernel.
struct KernelCase {
    std::string_view kernel;
    std::string_view ensemble;
    ChangeScene change;
};

/// One for each of kernel_names(), in their order.
[[nodiscard]] std::span<const KernelCase> kernel_cases();

/// The ensemble's first `count` shots for the seed, changed.
[[nodiscard]] std::vector<Scene> changed_scenes(std::string_view ensemble, std::uint64_t seed,
                                                std::size_t count, ChangeScene change);

}  // namespace poolhall::lab
