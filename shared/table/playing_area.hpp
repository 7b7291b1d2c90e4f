#pragma once

#include "shared/table/table.hpp"

namespace poolhall {

/// Whether a ball of the given radius (m), centred at r (m), lies inside the rails and in no hole
/// of a pool table: within the noses, or in a mouth and clear of its rubber. It may reach `slack` m
/// into the rubber, as far as rounding goes. An endless cloth has room everywhere. A pool table
/// must have no fault_of_mouths().
[[nodiscard]] bool is_on_table(const Table& table, Vec2 r, Real radius, Real slack);

}  // namespace poolhall
