#pragma once

#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <ostream>

// What came of simulating a scene: files of schema poolhall.result/1.
namespace poolhall::protocol {

/// One ShotEvent with the scene's ball ids: {"t", "kind", "balls", "rail" | "pocket", "at",
/// "before", "after"}.
[[nodiscard]] nlohmann::ordered_json to_json(const ShotEvent& event, const Scene& scene);

enum class Numbers : std::uint8_t {
    kDecimal,   ///< the shortest that reads back to the same double
    kHexFloat,  ///< strings with C hex-floats, "0x1.8p-1": two machines' bits compare as text
};

struct ResultForm {
    Numbers numbers = Numbers::kDecimal;
    std::optional<std::uint64_t> cost_ns = {};  ///< what the simulation took; adds "cost"
};

/// Writes the result of the scene on one line, without the newline. Events and samples go out one
/// by one, so a million of them take no more memory than one. Whether it arrived, the stream says.
void write_result(std::ostream& out, const ShotTrace& trace, const Scene& scene,
                  const ResultForm& form = {});

}  // namespace poolhall::protocol
