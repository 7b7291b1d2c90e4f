#include "shared/table/presets.hpp"

#include <array>

namespace poolhall {

namespace {

constexpr Real kInch = 0.0254;  // m

/// 4 1/4 in at the corners, half an inch more at the sides.
constexpr Mouths kTightMouths = [] {
    Mouths mouths;
    mouths.corner.width = 4.25 * kInch;
    mouths.side.width = 4.75 * kInch;
    return mouths;
}();

/// Jaws of wide arcs. A corner's facings are parallel, {sin 45, cos 45}; a middle pocket's close in
/// by 20 degrees, {sin 20, cos 20}.
constexpr Mouths kRoundMouths{
    .corner = {.width = 0.086,
               .facing = {0.70710678118654752, 0.70710678118654752},
               .jaw_radius = 3.6 * kInch,
               .shelf = 0.036,
               .hole_radius = 0.047},
    .side = {.width = 0.116,
             .facing = {0.34202014332566873, 0.93969262078590838},
             .jaw_radius = 2.5 * kInch,
             .shelf = 0,
             .hole_radius = 0.0445},
};

struct TableRow {
    Real length;  ///< m
    Real width;   ///< m
    PocketModel pockets;
    std::optional<Mouths> mouths;
};

constexpr std::array<TableRow, kCount<TablePreset>> kTables{{
    {100 * kInch, 50 * kInch, PocketModel::kPool, std::nullopt},
    {100 * kInch, 50 * kInch, PocketModel::kPool, kTightMouths},
    {92 * kInch, 46 * kInch, PocketModel::kPool, std::nullopt},
    {88 * kInch, 44 * kInch, PocketModel::kPool, std::nullopt},
    {80 * kInch, 40 * kInch, PocketModel::kPool, std::nullopt},
    {3.569, 1.778, PocketModel::kPool, kRoundMouths},
    {2.84, 1.42, PocketModel::kNone, std::nullopt},
}};

struct BallRow {
    BallSpec all;
    std::optional<BallSpec> cue;
};

constexpr std::array<BallRow, kCount<BallSet>> kBalls{{
    {{0.028575, 0.165}, std::nullopt},
    {{0.028575, 0.163}, BallSpec{0.028575, 0.167}},
    {{0.028575, 0.163}, BallSpec{0.03015, 0.21}},
    {{0.02625, 0.1406}, std::nullopt},
    {{0.03075, 0.21}, std::nullopt},
}};

}  // namespace

Table preset_value(TablePreset preset) {
    const TableRow& row = kTables[static_cast<std::size_t>(preset)];
    Table table;
    table.length = row.length;
    table.width = row.width;
    table.pockets = row.pockets;
    table.mouths = row.mouths;
    return table;
}

BallSpec preset_value(BallSet set) {
    return kBalls[static_cast<std::size_t>(set)].all;
}

std::optional<BallSpec> cue_ball_of(BallSet set) {
    return kBalls[static_cast<std::size_t>(set)].cue;
}

}  // namespace poolhall
