#include "client/desktop/view/table_painter.hpp"

#include "client/desktop/view/cushions.hpp"
#include "client/desktop/view/materials.hpp"
#include "client/desktop/view/pocket_holes.hpp"
#include "shared/game/end_game.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace poolhall::client {
namespace {

constexpr float kRim = 0.5F;         // ball radii, as all lengths here
constexpr float kLeastWood = 0.85F;  // between the back of a pocket and the frame's edge
constexpr double kFootSpot = 0.25;   // of a pool table's length, from its middle
constexpr float kShadow = 3;
constexpr float kOuterRounding = 2.4F;
constexpr Rgb kLeather{0.150F, 0.115F, 0.095F};
constexpr Rgb kPit{0.010F, 0.012F, 0.014F};
constexpr Rgb kBrass{0.66F, 0.50F, 0.25F};
constexpr Rgb kPearl{0.93F, 0.90F, 0.80F};

using Point = SDL_FPoint;

struct DrawnHole {
    Point at;
    float radius;
};

std::optional<double> foot_spot_of(const Table& table) {
    if (table.pockets == PocketModel::kEndGame) return end_game::kFootSpotX;
    if (table.pockets == PocketModel::kPool) return kFootSpot * table.length;
    return std::nullopt;
}

double radius_of_ball(const Layout& layout) {
    return static_cast<double>(layout.ball) / static_cast<double>(layout.scale);
}

float reach_beyond_noses(const Table& table) {
    if (!table.rails) return 1e6F;
    return table.pockets == PocketModel::kCircles ? 0 : kCushionWidth + kWoodWidth - kLeastWood;
}

class Painter {
  public:
    Painter(const Table& table, const Layout& layout);

    [[nodiscard]] Rgb colour(int pixel_x, int pixel_y) const;

  private:
    struct Near {
        const DrawnHole* hole = nullptr;
        float distance = 1e6F;  // from its centre
        float beyond = 1e6F;    // its edge
    };

    [[nodiscard]] float cover(float distance) const { return saturate(0.5F - distance / pixel_); }

    [[nodiscard]] Near nearest_hole(Point p) const;

    [[nodiscard]] float beyond_nose(Point p) const {
        return std::max(std::abs(p.x) - half_.x, std::abs(p.y) - half_.y);
    }

    [[nodiscard]] bool short_rail(Point p) const {
        return std::abs(p.x) - half_.x > std::abs(p.y) - half_.y;
    }

    [[nodiscard]] float beyond_frame(Point p) const;

    [[nodiscard]] Rgb room(Point p) const;
    [[nodiscard]] Rgb frame(Point p) const;
    [[nodiscard]] float sight(Point p) const;
    [[nodiscard]] Rgb bed(Point p, int pixel_x, int pixel_y) const;
    [[nodiscard]] Rgb cushion(Point p, const Cushions::Place& place, int pixel_x,
                              int pixel_y) const;
    [[nodiscard]] float lamp(Point p) const;
    [[nodiscard]] Rgb with_pocket(Rgb below, Point p) const;

    Layout layout_;
    Point half_;   // from the centre to the noses
    Point outer_;  // to the frame's edge
    float pixel_;  // a pixel's size
    bool rails_;
    Cushions cushions_;
    PocketModel model_;
    std::optional<Point> foot_spot_;
    std::vector<DrawnHole> holes_;
    float back_;  // how far beyond the noses a hole reaches at most
};

Painter::Painter(const Table& table, const Layout& layout)
    : layout_(layout),
      half_{layout.cloth.w / 2 / layout.ball, layout.cloth.h / 2 / layout.ball},
      outer_{layout.table.w / 2 / layout.ball, layout.table.h / 2 / layout.ball},
      pixel_(1 / layout.ball),
      rails_(table.rails),
      cushions_(table, radius_of_ball(layout)),
      model_(table.pockets),
      back_(reach_beyond_noses(table)) {
    const double radius = radius_of_ball(layout);
    const auto in_radii = [radius](double metres) { return static_cast<float>(metres / radius); };
    if (const auto spot = foot_spot_of(table)) foot_spot_ = Point{in_radii(*spot), 0};
    for (const PocketHole& hole : pocket_holes(table, radius))
        holes_.push_back(
            {{in_radii(hole.centre.x), in_radii(hole.centre.y)}, in_radii(hole.radius)});
}

Painter::Near Painter::nearest_hole(Point p) const {
    Near nearest;
    for (const DrawnHole& hole : holes_) {
        const float distance = std::hypot(p.x - hole.at.x, p.y - hole.at.y);
        const float beyond = distance - hole.radius;
        if (beyond < nearest.beyond) nearest = {&hole, distance, beyond};
    }
    nearest.beyond = std::max(nearest.beyond, beyond_nose(p) - back_);
    return nearest;
}

float Painter::beyond_frame(Point p) const {
    const float x = std::abs(p.x) - outer_.x + kOuterRounding;
    const float y = std::abs(p.y) - outer_.y + kOuterRounding;
    return std::hypot(std::max(x, 0.0F), std::max(y, 0.0F)) + std::min(std::max(x, y), 0.0F) -
           kOuterRounding;
}

Rgb Painter::room(Point p) const {
    const float distance = beyond_frame({p.x, p.y + 0.5F});  // the light comes from above
    return (1 - 0.7F * smooth_step(kShadow - 0.6F, -0.5F, distance)) * kRoom;
}

float Painter::sight(Point p) const {
    const bool short_side = short_rail(p);
    const float along = short_side ? p.y : p.x;
    const float spacing = short_side ? half_.y / 2 : half_.x / 4;
    const float nearest = spacing * std::round(along / spacing);
    const bool side_pockets = model_ == PocketModel::kEndGame || model_ == PocketModel::kPool;
    const bool at_pocket = !short_side && side_pockets && std::abs(nearest) < spacing / 2;
    if (at_pocket || std::abs(nearest) > (short_side ? half_.y : half_.x) - spacing / 2) return 0;
    const float across = beyond_nose(p) - kCushionWidth - kWoodWidth / 2;
    return cover((1.7F * std::abs(along - nearest) + std::abs(across) - 0.42F) * 0.55F);
}

Rgb Painter::frame(Point p) const {
    const bool short_side = short_rail(p);
    const float along = short_side ? p.y : p.x;
    const float across = short_side ? p.x : p.y;
    // Each of the four rails is another piece of wood.
    Rgb colour = wood(along + (across < 0 ? 200.0F : 90.0F), short_side ? across + 40 : across);
    const float from_cushion = beyond_nose(p) - kCushionWidth;
    const float to_edge = -beyond_frame(p);
    const float lit_side = (short_side ? (p.x < 0 ? 0.6F : -0.6F) : (p.y > 0 ? 1.0F : -1.0F));
    const float outer_bevel = smooth_step(0.55F, 0, to_edge);
    const float inner_bevel = smooth_step(0.35F, 0, from_cushion);
    const float gloss =
        std::exp(-6 * (from_cushion / kWoodWidth - 0.42F) * (from_cushion / kWoodWidth - 0.42F));
    const float mitre =
        std::abs(std::abs(std::abs(p.x) - half_.x) - std::abs(std::abs(p.y) - half_.y));
    const float joint =
        std::abs(p.x) > half_.x && std::abs(p.y) > half_.y ? cover(mitre - 0.05F) : 0;
    const float light = 0.80F + 0.22F * gloss +
                        0.34F * lit_side * (outer_bevel - 0.8F * inner_bevel) - 0.12F * inner_bevel;
    colour = (light * (1 - 0.45F * joint)) * colour;
    return mix(colour, 0.93F * kPearl, sight(p));
}

float Painter::lamp(Point p) const {
    const float distance = std::hypot(p.x / outer_.x, p.y / outer_.y);
    return 1.14F - 0.50F * smooth_step(0.05F, 1.35F, distance);
}

Rgb Painter::bed(Point p, int pixel_x, int pixel_y) const {
    float light = lamp(p);
    if (rails_) {
        const float to_rail = std::max(-beyond_nose(p), 0.0F);
        const float under_north = std::max(half_.y - p.y, 0.0F);
        const float by_west = std::max(half_.x + p.x, 0.0F);
        light *= 1 - 0.30F * std::exp(-1.5F * to_rail) - 0.22F * std::exp(-1.1F * under_north) -
                 0.12F * std::exp(-1.3F * by_west);
    }
    Rgb colour = cloth(pixel_x, pixel_y, light);
    if (foot_spot_) {
        const float spot = cover(std::hypot(p.x - foot_spot_->x, p.y - foot_spot_->y) - 0.2F);
        colour = mix(colour, {0.02F, 0.05F, 0.04F}, 0.75F * spot);
    }
    return colour;
}

Rgb Painter::cushion(Point p, const Cushions::Place& place, int pixel_x, int pixel_y) const {
    const float depth = -place.outside / kCushionWidth;
    const float lit_side = place.normal.y - 0.5F * place.normal.x;
    // From the face inwards: an edge that catches the light, a slope, the flat top.
    const float slope = smooth_step(0.62F, 0.10F, depth);
    const float nose = smooth_step(0.0F, 0.05F, depth) * smooth_step(0.20F, 0.06F, depth);
    const float back = smooth_step(0.86F, 1.0F, beyond_nose(p) / kCushionWidth);
    const float light = 0.80F + 0.17F * lit_side * slope + 0.26F * nose - 0.35F * back;
    return cloth(pixel_x, pixel_y, lamp(p) * light);
}

Rgb Painter::with_pocket(Rgb below, Point p) const {
    const auto [hole, distance, beyond] = nearest_hole(p);
    if (hole == nullptr || beyond > 2) return below;
    const Point out{(p.x - hole->at.x) / std::max(distance, 0.01F),
                    (p.y - hole->at.y) / std::max(distance, 0.01F)};
    const float facing_light =
        0.62F * out.y - 0.5F * out.x;  // of the way out; the wall inside faces back

    // The cloth bends down into the hole.
    Rgb colour = (1 - 0.55F * smooth_step(0.45F, 0.0F, beyond)) * below;
    // The leather is as wide as can be at the back and ends at the noses; a brass band holds it.
    const float rim = kRim * smooth_step(-0.15F, 1.1F, beyond_nose(p));
    const float round = rim > 0 ? 1 - std::abs(2 * beyond / rim - 1) : 0;
    const Rgb leather = (0.75F + 0.9F * std::max(round, 0.0F) * (0.6F + facing_light)) * kLeather;
    colour = mix(colour, leather, cover(beyond - rim));
    const float band = rim > 0.1F ? cover(std::abs(beyond - rim) - 0.055F) : 0;
    colour = mix(colour, (0.70F + 0.45F * facing_light) * kBrass, band);

    const float wall = smooth_step(0.55F, 1.0F, distance / hole->radius);
    const Rgb inside = mix(kPit, (1.0F - 1.1F * facing_light) * kLeather, 0.8F * wall * wall);
    return mix(colour, inside, cover(beyond));
}

Rgb Painter::colour(int pixel_x, int pixel_y) const {
    const Point p{(static_cast<float>(pixel_x) + 0.5F - layout_.centre.x) * pixel_,
                  (layout_.centre.y - static_cast<float>(pixel_y) - 0.5F) * pixel_};
    const float on_table = cover(beyond_frame(p));
    if (on_table == 0) return room(p);
    if (!rails_) return mix(room(p), bed(p, pixel_x, pixel_y), on_table);
    const float depth = beyond_nose(p);
    Rgb colour = depth < kCushionWidth ? bed(p, pixel_x, pixel_y) : frame(p);
    if (depth > -pixel_ && depth < kCushionWidth + pixel_) {
        const Rgb behind = mix(colour, frame(p), cover(kCushionWidth - depth));
        const Cushions::Place place = cushions_.at(p);
        colour = mix(behind, cushion(p, place, pixel_x, pixel_y),
                     cover(place.outside) * cover(depth - kCushionWidth));
    }
    return mix(room(p), with_pocket(colour, p), on_table);
}

}  // namespace

SDL_Rect table_picture_rect(const Layout& layout) {
    const float margin = kShadow * layout.ball;
    const int left = static_cast<int>(std::floor(layout.table.x - margin));
    const int top = static_cast<int>(std::floor(layout.table.y - margin));
    const int right = static_cast<int>(std::ceil(layout.table.x + layout.table.w + margin));
    const int bottom = static_cast<int>(std::ceil(layout.table.y + layout.table.h + margin));
    return {left, top, right - left, bottom - top};
}

Image paint_table(const Table& table, const Layout& layout) {
    const SDL_Rect rect = table_picture_rect(layout);
    const Painter painter(table, layout);
    Image image(rect.w, rect.h);
    for (int y = 0; y < rect.h; ++y) {
        std::uint32_t* row = image.row(y);
        for (int x = 0; x < rect.w; ++x)
            row[x] = to_argb(painter.colour(rect.x + x, rect.y + y));
    }
    return image;
}

}  // namespace poolhall::client
