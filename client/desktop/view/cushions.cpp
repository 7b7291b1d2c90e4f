#include "client/desktop/view/cushions.hpp"

#include "shared/table/pool_table.hpp"

#include <array>

namespace poolhall::client {
namespace {

constexpr int kArcFaces = 8;  // few enough to be quick, and no corner is seen

// How the original game's mouths are drawn, whose rails have none: half their width at the nose, in
// ball radii, and by how much that shrinks with the depth.
struct DrawnMouth {
    double half_width;
    double narrowing;
};

constexpr DrawnMouth kDrawnCorner{2.55, 0.75};
constexpr DrawnMouth kDrawnSide{2.0, 0.35};

bool same_place(Vec2 a, Vec2 b) {
    constexpr double kRounding = 1e-9;  // m
    return norm(a - b) < kRounding;
}

}  // namespace

Cushions::Cushions(const Table& table, double ball_radius) : radius_(ball_radius) {
    if (!table.rails) return;
    switch (table.pockets) {
        case PocketModel::kNone:
        case PocketModel::kCircles:
            add_unbroken_rails(table);
            break;
        case PocketModel::kEndGame:
            add_end_game_rails(table);
            break;
        case PocketModel::kPool:
            add_pool_rails(table);
            break;
    }
}

Cushions::Place Cushions::at(SDL_FPoint p) const {
    Place nearest;
    for (const Piece& piece : pieces_) {
        Place here{-1e6F, {0, 0}};
        for (const Face& face : piece) {
            const float outside =
                (p.x - face.on.x) * face.normal.x + (p.y - face.on.y) * face.normal.y;
            if (outside > here.outside) here = {outside, face.normal};
        }
        if (here.outside < nearest.outside) nearest = here;
    }
    return nearest;
}

void Cushions::add_unbroken_rails(const Table& table) {
    const Vec2 half{table.length / 2, table.width / 2};
    for (const Vec2 out : {Vec2{0, 1}, Vec2{1, 0}, Vec2{0, -1}, Vec2{-1, 0}})
        pieces_.push_back({face({out.x * half.x, out.y * half.y}, -1 * out)});
}

void Cushions::add_end_game_rails(const Table& table) {
    const Vec2 half{table.length / 2, table.width / 2};
    // The facing of the mouth at `end`, where the rail goes `along` from there.
    const auto facing = [this](Vec2 end, Vec2 along, Vec2 out, const DrawnMouth& mouth) {
        return face(end + mouth.half_width * radius_ * along,
                    -1 * normalized(along + mouth.narrowing * out));
    };
    for (const double side : {-1.0, 1.0}) {
        const Vec2 up{0, side};
        const Vec2 right{side, 0};
        for (const Vec2 along : {Vec2{1, 0}, Vec2{-1, 0}}) {
            const Vec2 middle{0, side * half.y};
            const Vec2 corner{along.x * half.x, side * half.y};
            pieces_.push_back({face(middle, -1 * up), facing(middle, along, up, kDrawnSide),
                               facing(corner, -1 * along, up, kDrawnCorner)});
        }
        const Vec2 low{side * half.x, -half.y};
        const Vec2 high{side * half.x, half.y};
        pieces_.push_back({face(low, -1 * right), facing(low, {0, 1}, right, kDrawnCorner),
                           facing(high, {0, -1}, right, kDrawnCorner)});
    }
}

void Cushions::add_pool_rails(const Table& table) {
    constexpr std::size_t kNoses = 6;  // they come first
    const PoolTable pool(table);
    for (const CushionLine& nose : pool.lines().first(kNoses)) {
        Piece piece{face(nose.from, -1 * nose.normal)};
        for (const CushionArc& arc : pool.arcs()) {
            const Vec2 joint = arc.centre + arc.radius * arc.from;
            if (!same_place(joint, nose.from) && !same_place(joint, nose.to)) continue;
            for (int i = 1; i < kArcFaces; ++i) {
                const double share = static_cast<double>(i) / kArcFaces;
                const Vec2 out = normalized((1 - share) * arc.from + share * arc.to);
                piece.push_back(face(arc.centre + arc.radius * out, out));
            }
            piece.push_back(face(arc.centre + arc.radius * arc.to, arc.to));  // the facing
        }
        pieces_.push_back(std::move(piece));
    }
}

Cushions::Face Cushions::face(Vec2 on, Vec2 normal) const {
    return {{static_cast<float>(on.x / radius_), static_cast<float>(on.y / radius_)},
            {static_cast<float>(normal.x), static_cast<float>(normal.y)}};
}

}  // namespace poolhall::client
