#pragma once

#include "shared/math/vec2.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace poolhall {

/// North is +y, east (the foot rail) +x. Then the rail ends of a pool table, by pocket and rail.
/// Values enter records: new ones go to the end.
enum class Rail : std::uint8_t {
    kNorth,
    kEast,
    kSouth,
    kWest,
    kNorthWestJawN,
    kNorthWestJawW,
    kNorthJawW,  ///< a side pocket's, west of it
    kNorthJawE,
    kNorthEastJawN,
    kNorthEastJawE,
    kSouthEastJawS,
    kSouthEastJawE,
    kSouthJawW,
    kSouthJawE,
    kSouthWestJawS,
    kSouthWestJawW,
};

inline constexpr Rail kFirstJaw = Rail::kNorthWestJawN;
inline constexpr int kRailCount = 16;

enum class Pocket : std::uint8_t { kNorthWest, kNorth, kNorthEast, kSouthEast, kSouth, kSouthWest };

inline constexpr std::size_t kMaxPocketCircles = 64;
inline constexpr int kPocketCount = 6;

/// How balls leave the table.
enum class PocketModel : std::uint8_t {
    kNone,     ///< they do not
    kEndGame,  ///< the original game's: near two rails, or near a long rail's middle (pockets.hpp)
    kPool,     ///< mouths with jaws (pool_table.hpp)
    kCircles,  ///< Table::circles, the rails unbroken
};

/// Captures a ball whose centre comes within `radius` of `centre`.
struct PocketCircle {
    std::string id;
    Vec2 centre;      ///< m
    Real radius = 0;  ///< m

    friend bool operator==(const PocketCircle&, const PocketCircle&) = default;
};

struct Table {
    Real length = 2.54;  ///< nose to nose along x, m
    Real width = 1.27;   ///< nose to nose along y, m
    bool rails = true;   ///< false: an endless cloth
    PocketModel pockets = PocketModel::kNone;
    std::vector<PocketCircle> circles = {};  ///< with PocketModel::kCircles

    friend bool operator==(const Table&, const Table&) = default;
};

/// "N", "E", "S", "W"; "NW.N" is the end of the N rail at the pocket NW, "N.W" the jaw west of N.
[[nodiscard]] std::string_view name(Rail rail);
/// "NW", "N", "NE", "SE", "S", "SW".
[[nodiscard]] std::string_view name(Pocket pocket);

/// Where the centre of a ball of the given radius (m) is when it touches the rails: |x| and |y|, m.
[[nodiscard]] Vec2 inset(const Table& table, Real radius);

}  // namespace poolhall
