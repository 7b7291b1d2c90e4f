#include "client/desktop/view/overlays.hpp"

#include "client/desktop/render/colour.hpp"
#include "client/desktop/view/ball_painter.hpp"

#include <algorithm>
#include <array>

namespace poolhall::client {
namespace {

constexpr SDL_Color kWhite{255, 255, 255, 255};
constexpr SDL_Color kBlack{0, 0, 0, 255};
constexpr SDL_Color kMagenta{255, 64, 224, 255};
constexpr SDL_Color kYellow{255, 221, 40, 255};
constexpr SDL_Color kArrow{255, 236, 180, 255};
constexpr SDL_Color kIvoryTint{255, 247, 224, 255};
constexpr SDL_Color kBlackTint{12, 14, 16, 255};
constexpr SDL_Color kRedTint{220, 70, 60, 255};

SDL_Color tint_of(BallLook look) {
    switch (look) {
        case BallLook::kIvory:
            return kIvoryTint;
        case BallLook::kEight:
            return kBlackTint;
        case BallLook::kPlain:
            return kRedTint;
    }
    return kWhite;
}

// Unit vector on the screen.
SDL_FPoint on_screen(Vec2 direction) {
    const Vec2 unit = normalized(direction);
    return {static_cast<float>(unit.x), static_cast<float>(-unit.y)};
}

SDL_FPoint along(SDL_FPoint from, SDL_FPoint direction, float distance) {
    return {from.x + distance * direction.x, from.y + distance * direction.y};
}

void add_arrow(Mesh& mesh, SDL_FPoint tail, SDL_FPoint direction, float ball, SDL_Color colour) {
    const float tip = kArrowLength * ball;
    const float neck = tip - 1.05F * ball;
    const SDL_FPoint left{direction.y, -direction.x};
    const auto at = [&](float forward, float sideways) {
        return along(along(tail, direction, forward), left, sideways * ball);
    };
    const std::array<SDL_FPoint, 4> shaft{at(0, 0.06F), at(neck, 0.13F), at(neck, -0.13F),
                                          at(0, -0.06F)};
    const std::array<SDL_FPoint, 3> head{at(neck, 0.42F), at(tip, 0), at(neck, -0.42F)};
    add_convex(mesh, shaft, colour);
    add_convex(mesh, head, colour);
}

void add_path(Mesh& mesh, const Layout& layout, const PathSegment& path, SDL_Color colour) {
    const SDL_FPoint from = layout.to_pixels(path.from);
    const SDL_FPoint to = layout.to_pixels(path.to);
    add_line(mesh, from, to, {hair(layout), colour});
    add_ring(mesh, to, layout.ball, {0.7F * hair(layout), faded(colour, 0.55F)});
}

void add_footprint(Mesh& mesh, SDL_FPoint middle, float size, SDL_Color colour) {
    // A sole, a heel, and the gap between them.
    add_rounded_rect(mesh,
                     {middle.x - 0.19F * size, middle.y - 0.52F * size, 0.38F * size, 0.62F * size},
                     0.19F * size, colour);
    add_rounded_rect(
        mesh, {middle.x - 0.145F * size, middle.y + 0.18F * size, 0.29F * size, 0.32F * size},
        0.145F * size, colour);
}

void add_badge(Mesh& mesh, SDL_FPoint middle, float radius) {
    add_disc(mesh, middle, radius, {238, 226, 198, 255});
    add_ring(mesh, middle, radius, {std::max(1.0F, 0.1F * radius), {60, 36, 20, 255}});
}

}  // namespace

float hair(const Layout& layout) {
    return std::max(1.2F, 0.085F * layout.ball);
}

void add_placement(Mesh& mesh, const Layout& layout, const Region& region) {
    const Stroke stroke{hair(layout), faded(kWhite, 0.42F)};
    // Nearly to where the ball's edge comes, along whatever length the region has.
    const float reach = 0.85F * layout.ball;
    const float along = region.low.x < region.high.x ? reach : 0;
    const float across = region.low.y < region.high.y ? reach : 0;
    const SDL_FPoint low = layout.to_pixels(region.low);
    const SDL_FPoint high = layout.to_pixels(region.high);
    const float left = low.x - along;
    const float right = high.x + along;
    const float top = high.y - across;
    const float bottom = low.y + across;
    if (along > 0) add_line(mesh, {left, bottom}, {right, bottom}, stroke);
    if (across > 0) add_line(mesh, {left, top}, {left, bottom}, stroke);
    if (along == 0 || across == 0) return;
    add_line(mesh, {left, top}, {right, top}, stroke);
    add_line(mesh, {right, top}, {right, bottom}, stroke);
}

void add_ball_shadow(Mesh& mesh, const Layout& layout, Vec2 r) {
    const SDL_FPoint at = layout.to_pixels(r);
    const float ball = layout.ball;
    add_glow(mesh, {at.x + 0.22F * ball, at.y + 0.30F * ball}, {1.35F * ball, 1.30F * ball},
             faded(kBlack, 0.62F));
}

void add_trail(Mesh& mesh, const Layout& layout, const ViewState& state) {
    for (const TrailRing& ring : state.trail) {
        if (ring.ball.value >= state.balls.size()) continue;
        const SDL_Color tint = tint_of(look_of(state.balls[ring.ball.value].id));
        const float strength = 0.9F * saturate(static_cast<float>(ring.strength));
        add_ring(mesh, layout.to_pixels(ring.r), layout.ball - hair(layout) / 2,
                 {hair(layout), faded(tint, strength)});
    }
}

void add_aim(Mesh& mesh, const Layout& layout, const AimView& aim) {
    if (norm(normalized(aim.direction)) == 0) return;
    const AimPrediction& seen = aim.prediction;
    const float thin = hair(layout);
    add_dashed_line(mesh, layout.to_pixels(seen.cue_path.from), layout.to_pixels(seen.cue_path.to),
                    std::max(4.0F, 0.35F * layout.ball), {thin, faded(kWhite, 0.62F)});
    if (seen.object_after) add_path(mesh, layout, *seen.object_after, faded(kMagenta, 0.95F));
    if (seen.cue_after) add_path(mesh, layout, *seen.cue_after, faded(kWhite, 0.85F));
    if (seen.ghost_ball) {
        const SDL_FPoint ghost = layout.to_pixels(*seen.ghost_ball);
        add_disc(mesh, ghost, layout.ball - thin, faded(kWhite, 0.16F));
        add_ring(mesh, ghost, layout.ball - thin / 2, {1.2F * thin, faded(kWhite, 0.92F)});
    }
    const SDL_FPoint tail = layout.to_pixels(aim.from);
    const SDL_FPoint direction = on_screen(aim.direction);
    const float drop = 0.1F * layout.ball;
    add_arrow(mesh, {tail.x + drop, tail.y + 1.4F * drop}, direction, layout.ball,
              faded(kBlack, 0.32F));
    add_arrow(mesh, tail, direction, layout.ball, kArrow);
}

void add_collision_marks(Mesh& mesh, const Layout& layout,
                         const std::vector<CollisionMark>& marks) {
    const float width = 1.35F * hair(layout);
    for (const CollisionMark& mark : marks) {
        const SDL_FPoint at = layout.to_pixels(mark.r);
        add_ring(mesh, at, layout.ball, {width + 2, faded(kBlack, 0.30F)});
        add_ring(mesh, at, layout.ball, {width, kYellow});
    }
}

void add_mode_icons(Mesh& mesh, const Layout& layout, const ViewState& state) {
    const float radius = std::max(0.86F * layout.ball, 8.0F);
    const float gap = 0.25F * radius;
    const float y = layout.table.y + layout.table.h - kWoodWidth / 2 * layout.ball;
    float x = layout.cloth.x + 2.55F * layout.ball + radius;
    if (state.step_mode) {
        add_badge(mesh, {x, y}, radius);
        add_footprint(mesh, {x - 0.33F * radius, y + 0.18F * radius}, 0.95F * radius, kBlackTint);
        add_footprint(mesh, {x + 0.33F * radius, y - 0.16F * radius}, 0.95F * radius, kBlackTint);
        x += 2 * radius + gap;
    }
    if (state.collision_mode) {
        add_badge(mesh, {x, y}, radius);
        add_disc(mesh, {x, y}, 0.5F * radius, kBlackTint);
    }
}

}  // namespace poolhall::client
