#include "shared/table/table.hpp"

namespace poolhall {

Real rail_reach(const Table& table, Real radius) {
    if (!table.nose_height) return radius;
    const Real height = *table.nose_height;
    return sqrt(height * (2 * radius - height));
}

Vec2 inset(const Table& table, Real radius) {
    const Real reach = rail_reach(table, radius);
    return {table.length / 2 - reach, table.width / 2 - reach};
}

}  // namespace poolhall
