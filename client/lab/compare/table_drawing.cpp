#include "client/lab/compare/table_drawing.hpp"

#include "shared/table/pockets.hpp"
#include "shared/table/pool_table.hpp"

#include <array>
#include <cmath>

namespace poolhall::lab {

namespace {

constexpr double kBehindTheNoses = 0.05;  // m
constexpr double kBehindTheHoles = 0.15;
constexpr Colour kCloth{0.945, 0.965, 0.945};
constexpr Colour kHole{0.70, 0.72, 0.70};
const Pen kRail{{0.25, 0.25, 0.25}, 3};
const Pen kEdge{{0.45, 0.45, 0.45}, 1.5};

double angle_of(Vec2 direction) {
    return std::atan2(-direction.y, direction.x);
}

void draw_pool_table(Drawing& drawing, const Table& table, const TableScale& scale) {
    const PoolTable pool(table);
    for (const Hole& hole : pool.holes()) {
        drawing.disc(scale.at(hole.centre), scale.px_a_metre * hole.radius, kHole);
        drawing.ring(scale.at(hole.centre), scale.px_a_metre * hole.radius, kEdge);
    }
    for (const CushionLine& line : pool.lines())
        drawing.line(std::array{scale.at(line.from), scale.at(line.to)}, kRail);
    for (const CushionArc& arc : pool.arcs())
        drawing.arc(scale.at(arc.centre), scale.px_a_metre * arc.radius, angle_of(arc.from),
                    angle_of(arc.to), kRail);
}

void fill(Drawing& drawing, const TableScale& scale, const Extent& part, Colour colour) {
    const Pixel corner = scale.at({part.least.x, part.most.y});
    const Vec2 size = scale.px_a_metre * (part.most - part.least);
    drawing.fill_rectangle(corner, size.x, size.y, colour);
}

/// The places whose ball counts as pocketed in the original game.
void draw_end_game_captures(Drawing& drawing, const Scene& scene, const TableScale& scale) {
    const EndGamePocketMap map(scene.table, scene.ball.radius);
    const double x = scene.table.length / 2;
    const double y = scene.table.width / 2;
    const std::array<std::pair<double, double>, 3> along{
        {{-x, -map.corner_x()}, {-map.centre_x(), map.centre_x()}, {map.corner_x(), x}}};
    for (const auto& [from, to] : along) {
        fill(drawing, scale, {{from, map.near_rail_y()}, {to, y}}, kHole);
        fill(drawing, scale, {{from, -y}, {to, -map.near_rail_y()}}, kHole);
    }
}

void draw_captures(Drawing& drawing, const Scene& scene, const TableScale& scale) {
    if (scene.table.pockets == PocketModel::kEndGame) draw_end_game_captures(drawing, scene, scale);
    if (scene.table.pockets != PocketModel::kCircles) return;
    for (const PocketCircle& circle : scene.table.circles) {
        drawing.disc(scale.at(circle.centre), scale.px_a_metre * circle.radius, kHole);
        drawing.ring(scale.at(circle.centre), scale.px_a_metre * circle.radius, kEdge);
    }
}

void draw_rails(Drawing& drawing, const Table& table, const TableScale& scale) {
    const double x = table.length / 2;
    const double y = table.width / 2;
    drawing.line(std::array{scale.at({-x, -y}), scale.at({-x, y}), scale.at({x, y}),
                            scale.at({x, -y}), scale.at({-x, -y})},
                 kRail);
}

}  // namespace

Extent extent_of(const Table& table) {
    if (!table.rails) return {};
    const double behind = table.pockets == PocketModel::kPool ? kBehindTheHoles : kBehindTheNoses;
    const Vec2 corner{table.length / 2 + behind, table.width / 2 + behind};
    return {-1 * corner, corner};
}

void draw_table(Drawing& drawing, const Scene& scene, const TableScale& scale,
                const Extent& extent) {
    fill(drawing, scale, extent, kCloth);
    draw_captures(drawing, scene, scale);
    if (scene.table.pockets == PocketModel::kPool)
        draw_pool_table(drawing, scene.table, scale);
    else if (scene.table.rails)
        draw_rails(drawing, scene.table, scale);
}

}  // namespace poolhall::lab
