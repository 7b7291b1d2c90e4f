#include "client/desktop/render/mesh.hpp"

#include "client/desktop/render/colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace poolhall::client {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kFeather = 0.5F;  // px to either side of an edge

SDL_FPoint operator+(SDL_FPoint a, SDL_FPoint b) {
    return {a.x + b.x, a.y + b.y};
}

SDL_FPoint operator-(SDL_FPoint a, SDL_FPoint b) {
    return {a.x - b.x, a.y - b.y};
}

SDL_FPoint operator*(float s, SDL_FPoint a) {
    return {s * a.x, s * a.y};
}

SDL_FPoint polar(float angle) {
    return {std::cos(angle), std::sin(angle)};
}

int add_vertex(Mesh& mesh, SDL_FPoint at, SDL_Color colour) {
    mesh.vertices.push_back({at, colour, {0, 0}});
    return static_cast<int>(mesh.vertices.size()) - 1;
}

void add_triangle(Mesh& mesh, int a, int b, int c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

// Few enough sides to be cheap, so many that none deviates from the circle by a twentieth of a
// pixel.
int sides_of_circle(float radius) {
    return std::clamp(static_cast<int>(std::ceil(kPi * std::sqrt(10 * std::max(radius, 0.0F)))), 12,
                      180);
}

// A point of the strip's cross-section: how far from the middle, and how much of the colour is
// there.
struct Rib {
    float offset;
    float alpha;
};

struct Profile {
    std::array<Rib, 4> ribs;
};

// From transparent through full to transparent, as wide as the stroke.
Profile profile_of(float width) {
    const float half = std::max(width, 1.0F) / 2;
    const float alpha = std::min(width, 1.0F);
    return {{{{-half - kFeather, 0},
              {-half + kFeather, alpha},
              {half - kFeather, alpha},
              {half + kFeather, 0}}}};
}

// The strip's next cross-section, joined to the one before unless it is the first.
template <class Place>
void add_rib_row(Mesh& mesh, const Profile& profile, Stroke stroke, bool first, Place place) {
    const int base = static_cast<int>(mesh.vertices.size());
    for (const Rib& rib : profile.ribs)
        add_vertex(mesh, place(rib.offset), faded(stroke.colour, rib.alpha));
    if (first) return;
    constexpr int kRow = 4;
    for (int i = base; i < base + kRow - 1; ++i) {
        add_triangle(mesh, i - kRow, i - kRow + 1, i);
        add_triangle(mesh, i, i - kRow + 1, i + 1);
    }
}

std::vector<SDL_FPoint> rounded_corners(const SDL_FRect& rect, float radius) {
    const float r = std::clamp(radius, 0.0F, std::min(rect.w, rect.h) / 2);
    const int steps = std::max(2, sides_of_circle(r) / 4);
    const std::array<SDL_FPoint, 4> centres{{{rect.x + rect.w - r, rect.y + r},
                                             {rect.x + rect.w - r, rect.y + rect.h - r},
                                             {rect.x + r, rect.y + rect.h - r},
                                             {rect.x + r, rect.y + r}}};
    std::vector<SDL_FPoint> corners;
    for (std::size_t quarter = 0; quarter < centres.size(); ++quarter) {
        for (int i = 0; i <= steps; ++i) {
            const float turn =
                static_cast<float>(i) / static_cast<float>(steps) + static_cast<float>(quarter) - 1;
            corners.push_back(centres[quarter] + r * polar(turn * kPi / 2));
        }
    }
    return corners;
}

// Moves the corner outwards by 1 px along both its edges' normals: their mitre, bounded where it is
// sharp.
SDL_FPoint outward(SDL_FPoint before, SDL_FPoint corner, SDL_FPoint after) {
    const auto normal = [](SDL_FPoint a, SDL_FPoint b) {
        const SDL_FPoint d = b - a;
        const float length = std::hypot(d.x, d.y);
        return length > 0 ? SDL_FPoint{d.y / length, -d.x / length} : SDL_FPoint{0, 0};
    };
    const SDL_FPoint n1 = normal(before, corner);
    const SDL_FPoint n2 = normal(corner, after);
    const SDL_FPoint sum = n1 + n2;
    const float square = sum.x * sum.x + sum.y * sum.y;
    return square > 0 ? (2 / std::max(square, 0.5F)) * sum : n1;
}

// The edge of a polygon, from full to transparent. Each corner becomes two vertices, the inner one
// first; the answer is the first corner's, and filling the inside is left to the caller.
int add_feathered_outline(Mesh& mesh, std::span<const SDL_FPoint> corners, SDL_Color colour) {
    const std::size_t count = corners.size();
    const int base = static_cast<int>(mesh.vertices.size());
    for (std::size_t i = 0; i < count; ++i) {
        const SDL_FPoint push =
            outward(corners[(i + count - 1) % count], corners[i], corners[(i + 1) % count]);
        add_vertex(mesh, corners[i] - kFeather * push, colour);
        add_vertex(mesh, corners[i] + kFeather * push, faded(colour, 0));
    }
    const int sides = static_cast<int>(count);
    for (int i = 0; i < sides; ++i) {
        const int in = base + 2 * i;
        const int next = base + 2 * ((i + 1) % sides);
        add_triangle(mesh, in, in + 1, next);
        add_triangle(mesh, next, in + 1, next + 1);
    }
    return base;
}

}  // namespace

void add_disc(Mesh& mesh, SDL_FPoint centre, float radius, SDL_Color colour) {
    if (radius <= 0) return;
    const float inner = std::max(radius - kFeather, 0.0F);
    // A disc smaller than its feather is a cone one pixel wide: pi r^2 is kept by its height.
    const float alpha = std::min(1.0F, 3 * radius * radius);
    const float outer = std::max(radius + kFeather, 1.0F);
    const int sides = sides_of_circle(outer);
    const int middle = add_vertex(mesh, centre, faded(colour, alpha));
    for (int i = 0; i <= sides; ++i) {
        const SDL_FPoint ray =
            polar(2 * kPi * static_cast<float>(i % sides) / static_cast<float>(sides));
        const int in = add_vertex(mesh, centre + inner * ray, faded(colour, alpha));
        const int out = add_vertex(mesh, centre + outer * ray, faded(colour, 0));
        if (i == 0) continue;
        if (inner > 0) add_triangle(mesh, middle, in - 2, in);
        add_triangle(mesh, in - 2, out - 2, in);
        add_triangle(mesh, in, out - 2, out);
    }
}

void add_arc(Mesh& mesh, SDL_FPoint centre, float radius, Sweep sweep, Stroke stroke) {
    if (radius <= 0 || stroke.width <= 0) return;
    const Profile profile = profile_of(stroke.width);
    const float part = std::min(std::abs(sweep.to - sweep.from) / (2 * kPi), 1.0F);
    const int steps = std::max(
        2, static_cast<int>(std::ceil(part * static_cast<float>(sides_of_circle(radius)))));
    for (int i = 0; i <= steps; ++i) {
        const SDL_FPoint ray =
            polar(mix(sweep.from, sweep.to, static_cast<float>(i) / static_cast<float>(steps)));
        add_rib_row(mesh, profile, stroke, i == 0,
                    [&](float offset) { return centre + std::max(radius + offset, 0.0F) * ray; });
    }
}

void add_ring(Mesh& mesh, SDL_FPoint centre, float radius, Stroke stroke) {
    add_arc(mesh, centre, radius, {0, 2 * kPi}, stroke);
}

void add_line(Mesh& mesh, SDL_FPoint from, SDL_FPoint to, Stroke stroke) {
    const SDL_FPoint d = to - from;
    const float length = std::hypot(d.x, d.y);
    if (!(length > 0) || stroke.width <= 0) return;
    const SDL_FPoint along = (1 / length) * d;
    const SDL_FPoint across{-along.y, along.x};
    const float cap = std::min(kFeather, length / 2);
    const Profile profile = profile_of(stroke.width);
    const std::array<Rib, 4> ends{{{-cap, 0}, {cap, 1}, {length - cap, 1}, {length + cap, 0}}};
    bool first = true;
    for (const Rib& end : ends) {
        const Stroke part{stroke.width, faded(stroke.colour, end.alpha)};
        add_rib_row(mesh, profile, part, first,
                    [&](float offset) { return from + end.offset * along + offset * across; });
        first = false;
    }
}

void add_dashed_line(Mesh& mesh, SDL_FPoint from, SDL_FPoint to, float dash, Stroke stroke) {
    const SDL_FPoint d = to - from;
    const float length = std::hypot(d.x, d.y);
    if (!(length > 0) || !(dash >= 1)) return;
    const SDL_FPoint along = (1 / length) * d;
    const int dashes = static_cast<int>(length / (2 * dash)) + 1;
    for (int i = 0; i < dashes; ++i) {
        const float start = static_cast<float>(i) * 2 * dash;
        add_line(mesh, from + start * along, from + std::min(start + dash, length) * along, stroke);
    }
}

void add_convex(Mesh& mesh, std::span<const SDL_FPoint> corners, SDL_Color colour) {
    if (corners.size() < 3) return;
    const int base = add_feathered_outline(mesh, corners, colour);
    const int end = base + 2 * static_cast<int>(corners.size());
    for (int in = base + 4; in < end; in += 2)
        add_triangle(mesh, base, in - 2, in);
}

void add_star_shape(Mesh& mesh, SDL_FPoint middle, std::span<const SDL_FPoint> corners,
                    SDL_Color colour) {
    if (corners.size() < 3) return;
    const int base = add_feathered_outline(mesh, corners, colour);
    const int end = base + 2 * static_cast<int>(corners.size());
    const int hub = add_vertex(mesh, middle, colour);
    for (int in = base; in < end; in += 2)
        add_triangle(mesh, hub, in, in + 2 == end ? base : in + 2);
}

void add_rounded_rect(Mesh& mesh, const SDL_FRect& rect, float radius, SDL_Color colour) {
    if (rect.w <= 0 || rect.h <= 0) return;
    add_convex(mesh, rounded_corners(rect, std::max(radius, 1.0F)), colour);
}

void add_rounded_frame(Mesh& mesh, const SDL_FRect& rect, float radius, Stroke stroke) {
    if (rect.w <= 0 || rect.h <= 0 || stroke.width <= 0) return;
    const std::vector<SDL_FPoint> corners = rounded_corners(rect, std::max(radius, 1.0F));
    const Profile profile = profile_of(stroke.width);
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i <= count; ++i) {
        const SDL_FPoint at = corners[i % count];
        const SDL_FPoint push =
            outward(corners[(i + count - 1) % count], at, corners[(i + 1) % count]);
        add_rib_row(mesh, profile, stroke, i == 0,
                    [&](float offset) { return at + offset * push; });
    }
}

void add_glow(Mesh& mesh, SDL_FPoint centre, SDL_FPoint radii, SDL_Color colour) {
    if (radii.x <= 0 || radii.y <= 0) return;
    constexpr std::array<Rib, 5> kFall{
        {{0.3F, 0.93F}, {0.5F, 0.7F}, {0.7F, 0.37F}, {0.85F, 0.12F}, {1, 0}}};
    constexpr int kRow = static_cast<int>(kFall.size());
    const int sides = sides_of_circle(std::max(radii.x, radii.y) / 2);
    const int middle = add_vertex(mesh, centre, colour);
    for (int i = 0; i <= sides; ++i) {
        const SDL_FPoint ray =
            polar(2 * kPi * static_cast<float>(i % sides) / static_cast<float>(sides));
        const int base = static_cast<int>(mesh.vertices.size());
        for (const Rib& rib : kFall) {
            const SDL_FPoint offset{rib.offset * radii.x * ray.x, rib.offset * radii.y * ray.y};
            add_vertex(mesh, centre + offset, faded(colour, rib.alpha));
        }
        if (i == 0) continue;
        add_triangle(mesh, middle, base - kRow, base);
        for (int k = base; k < base + kRow - 1; ++k) {
            add_triangle(mesh, k - kRow, k - kRow + 1, k);
            add_triangle(mesh, k, k - kRow + 1, k + 1);
        }
    }
}

}  // namespace poolhall::client
