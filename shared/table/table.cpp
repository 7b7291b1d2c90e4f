#include "shared/table/table.hpp"

namespace poolhall {

Vec2 inset(const Table& table, Real radius) {
    return {table.length / 2 - radius, table.width / 2 - radius};
}

}  // namespace poolhall
