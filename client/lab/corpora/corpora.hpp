#pragma once

#include "client/lab/corpora/random.hpp"
#include "shared/physics/scene/scene.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

// Shots whose results every compiler, optimisation level and processor must agree on. No
// third-party library: tests/tooling compiles this for machines that have none.
namespace poolhall::lab {

struct Corpus {
    std::string_view name;
    int shots;
    Scene (*make)(Random& random, int shot);  ///< called in order with one generator
};

[[nodiscard]] std::span<const Corpus> corpora();

[[nodiscard]] std::vector<Scene> scenes_of(const Corpus& corpus);

/// Simulates all of it: the hash of the shots' hashes.
[[nodiscard]] std::uint64_t hash_of(const Corpus& corpus);

}  // namespace poolhall::lab
