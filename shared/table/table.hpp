#pragma once

#include "shared/enum_names.hpp"
#include "shared/fields.hpp"
#include "shared/math/vec2.hpp"
#include "shared/table/bounds.hpp"
#include "shared/table/mouths.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
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

/// "NW.N" is the end of the N rail at the pocket NW, "N.W" the jaw west of N.
constexpr auto enum_names(Rail /*type*/) {
    return names_of<Rail>({{Rail::kNorth, "N"},
                           {Rail::kEast, "E"},
                           {Rail::kSouth, "S"},
                           {Rail::kWest, "W"},
                           {Rail::kNorthWestJawN, "NW.N"},
                           {Rail::kNorthWestJawW, "NW.W"},
                           {Rail::kNorthJawW, "N.W"},
                           {Rail::kNorthJawE, "N.E"},
                           {Rail::kNorthEastJawN, "NE.N"},
                           {Rail::kNorthEastJawE, "NE.E"},
                           {Rail::kSouthEastJawS, "SE.S"},
                           {Rail::kSouthEastJawE, "SE.E"},
                           {Rail::kSouthJawW, "S.W"},
                           {Rail::kSouthJawE, "S.E"},
                           {Rail::kSouthWestJawS, "SW.S"},
                           {Rail::kSouthWestJawW, "SW.W"}});
}

inline constexpr Rail kFirstJaw = Rail::kNorthWestJawN;
inline constexpr int kRailCount = kCount<Rail>;

enum class Pocket : std::uint8_t { kNorthWest, kNorth, kNorthEast, kSouthEast, kSouth, kSouthWest };

constexpr auto enum_names(Pocket /*type*/) {
    return names_of<Pocket>({{Pocket::kNorthWest, "NW"},
                             {Pocket::kNorth, "N"},
                             {Pocket::kNorthEast, "NE"},
                             {Pocket::kSouthEast, "SE"},
                             {Pocket::kSouth, "S"},
                             {Pocket::kSouthWest, "SW"}});
}

inline constexpr int kPocketCount = kCount<Pocket>;
inline constexpr std::size_t kMaxPocketCircles = 64;

/// How balls leave the table.
enum class PocketModel : std::uint8_t {
    kNone,     ///< they do not
    kEndGame,  ///< the original game's: near two rails, or near a long rail's middle (pockets.hpp)
    kPool,     ///< mouths with jaws (pool_table.hpp)
    kCircles,  ///< Table::circles, the rails unbroken
};

/// Circles are written as the list of them.
constexpr auto enum_names(PocketModel /*type*/) {
    return names_of<PocketModel>({{PocketModel::kNone, "none"},
                                  {PocketModel::kEndGame, "end_game"},
                                  {PocketModel::kPool, "pool"},
                                  {PocketModel::kCircles, ""}});
}

/// Captures a ball whose centre comes within `radius` of `centre`.
struct PocketCircle {
    std::string id;
    Vec2 centre;      ///< m
    Real radius = 0;  ///< m

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("id", &PocketCircle::id, kIdBytes),
            fields::of(
                "x", [](auto& circle) -> auto& { return circle.centre.x; }, kPlaces)
                .in("m"),
            fields::of(
                "y", [](auto& circle) -> auto& { return circle.centre.y; }, kPlaces)
                .in("m"),
            fields::of("radius", &PocketCircle::radius, fields::positive(kMaxLength)).in("m")};
    }

    friend bool operator==(const PocketCircle&, const PocketCircle&) = default;
};

struct Table {
    Real length = 2.54;  ///< nose to nose along x, m
    Real width = 1.27;   ///< nose to nose along y, m
    bool rails = true;   ///< false: an endless cloth
    PocketModel pockets = PocketModel::kNone;
    std::vector<PocketCircle> circles = {};  ///< with PocketModel::kCircles
    std::optional<Mouths> mouths = {};       ///< with PocketModel::kPool; absent: Mouths{}
    /// Balls touch the noses at this height above the cloth, m: nearer to them than at their sides.
    /// Absent: at their sides, as most programs have it.
    std::optional<Real> nose_height = {};

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("length", &Table::length, fields::positive(kMaxLength)).in("m"),
            fields::of("width", &Table::width, fields::positive(kMaxLength)).in("m"),
            fields::of("rails", &Table::rails).or_default(),
            fields::of("pockets", &Table::pockets).or_default(),
            // In a file they stand in the place of the model's name.
            fields::of("pockets", &Table::circles, {0, kMaxPocketCircles}).or_default(),
            fields::of("mouths", &Table::mouths).hashed_if_there(),
            fields::of("nose_height", &Table::nose_height, fields::positive(kMaxLength))
                .in("m")
                .hashed_if_there()};
    }

    friend bool operator==(const Table&, const Table&) = default;
};

/// How far from a nose, seen from above, the centre of a ball on the cloth is that touches it (m):
/// its radius R or, touched at the height h, R cos(asin((h - R)/R)) = sqrt(h (2 R - h)).
[[nodiscard]] Real rail_reach(const Table& table, Real radius);

/// Where the centre of a ball of the given radius (m) is when it touches the rails: |x| and |y|, m.
[[nodiscard]] Vec2 inset(const Table& table, Real radius);

}  // namespace poolhall
