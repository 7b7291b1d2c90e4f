#pragma once

#include "client/lab/accuracy/ensemble_run.hpp"

#include <optional>
#include <vector>

// Runs that are about one number each, apart from the ensembles.
namespace poolhall::lab {

/// A ball in uniform motion that hits another, which stands, at an offset uniform between the two
/// grazes and with the tick at any moment of its way: how often a solver sees no hit, by speed.
/// Nothing if it was interrupted.
[[nodiscard]] std::optional<std::vector<Tunnelling>> run_tunnelling(const RunPlan& plan,
                                                                    Progress& progress);

/// What a shot costs in which 2, 4, ... 256 balls all move (crowd()). Nothing if it was
/// interrupted.
[[nodiscard]] std::optional<std::vector<CrowdCosts>> run_crowds(const RunPlan& plan,
                                                                Progress& progress);

}  // namespace poolhall::lab
