#include "shared/table/table.hpp"

#include <array>

namespace poolhall {

std::string_view name(Rail rail) {
    constexpr std::array<std::string_view, kRailCount> kNames{
        "N",    "E",    "S",    "W",    "NW.N", "NW.W", "N.W",  "N.E",
        "NE.N", "NE.E", "SE.S", "SE.E", "S.W",  "S.E",  "SW.S", "SW.W"};
    return kNames[static_cast<std::size_t>(rail)];
}

std::string_view name(Pocket pocket) {
    constexpr std::array<std::string_view, kPocketCount> kNames{"NW", "N", "NE", "SE", "S", "SW"};
    return kNames[static_cast<std::size_t>(pocket)];
}

Vec2 inset(const Table& table, Real radius) {
    return {table.length / 2 - radius, table.width / 2 - radius};
}

}  // namespace poolhall
