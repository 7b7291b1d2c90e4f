#include "client/desktop/render/rasterizer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace poolhall::client {
namespace {

constexpr std::int64_t kSubpixels = 256;
constexpr float kMaxCoordinate = 32768;  // px; keeps the products below within 64 bits
constexpr int kBandRows = 32;

struct Fixed {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

Fixed to_fixed(SDL_FPoint p) {
    const auto snap = [](float value) {
        const float bounded = std::clamp(value, -kMaxCoordinate, kMaxCoordinate);
        return static_cast<std::int64_t>(std::lround(bounded * static_cast<float>(kSubpixels)));
    };
    return {snap(p.x), snap(p.y)};
}

bool is_finite(SDL_FPoint p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
}

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
    const std::int64_t quotient = a / b;
    return quotient - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}

// Twice the area of the triangle of an edge and a point, as a x + b y + c; positive inside. The
// top-left rule is folded into c, so that a pixel's centre on an edge shared by two triangles
// belongs to one of them.
struct Edge {
    std::int64_t a;
    std::int64_t b;
    std::int64_t c;

    Edge(Fixed from, Fixed to) : a(from.y - to.y), b(to.x - from.x), c(-(a * from.x + b * from.y)) {
        const bool top_left = a > 0 || (a == 0 && b > 0);
        if (!top_left) --c;
    }
};

struct Span {
    int from;
    int to;  // exclusive
};

// The pixels of a row whose centres are inside all three edges.
Span span_of(const std::array<Edge, 3>& edges, int y, Span bounds) {
    const std::int64_t centre_y = y * kSubpixels + kSubpixels / 2;
    std::int64_t low = bounds.from;
    std::int64_t high = bounds.to;
    for (const Edge& edge : edges) {
        const std::int64_t rest = edge.b * centre_y + edge.c + edge.a * (kSubpixels / 2);
        const std::int64_t slope = edge.a * kSubpixels;
        if (slope > 0) low = std::max(low, -floor_div(rest, slope));
        if (slope < 0) high = std::min(high, floor_div(rest, -slope) + 1);
        if (slope == 0 && rest < 0) return {0, 0};
    }
    return {static_cast<int>(low), static_cast<int>(std::max(low, high))};
}

struct Rgba {
    float r = 0;
    float g = 0;
    float b = 0;
    float a = 0;
};

Rgba operator+(Rgba p, Rgba q) {
    return {p.r + q.r, p.g + q.g, p.b + q.b, p.a + q.a};
}

Rgba operator-(Rgba p, Rgba q) {
    return {p.r - q.r, p.g - q.g, p.b - q.b, p.a - q.a};
}

Rgba operator*(float s, Rgba p) {
    return {s * p.r, s * p.g, s * p.b, s * p.a};
}

Rgba to_rgba(SDL_Color c) {
    return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b),
            static_cast<float>(c.a)};
}

// Colour as a linear function of the pixel's centre.
struct Gradient {
    Rgba origin;
    Rgba by_x;
    Rgba by_y;

    Gradient(const SDL_Vertex& a, const SDL_Vertex& b, const SDL_Vertex& c) {
        const SDL_FPoint ab{b.position.x - a.position.x, b.position.y - a.position.y};
        const SDL_FPoint ac{c.position.x - a.position.x, c.position.y - a.position.y};
        const float area = ab.x * ac.y - ab.y * ac.x;
        const Rgba d1 = to_rgba(b.color) - to_rgba(a.color);
        const Rgba d2 = to_rgba(c.color) - to_rgba(a.color);
        if (std::abs(area) > 1e-6F) {
            by_x = (1 / area) * (ac.y * d1 - ab.y * d2);
            by_y = (1 / area) * (ab.x * d2 - ac.x * d1);
        }
        origin = to_rgba(a.color) - a.position.x * by_x - a.position.y * by_y;
    }

    [[nodiscard]] Rgba at(float x, float y) const { return origin + x * by_x + y * by_y; }
};

std::uint32_t pack(Rgba c) {
    const auto byte = [](float v) {
        const float and_a_half = std::clamp(v, 0.0F, 255.0F) + 0.5F;  // rounds what is not negative
        return static_cast<std::uint32_t>(and_a_half);
    };
    return byte(c.a) << 24U | byte(c.r) << 16U | byte(c.g) << 8U | byte(c.b);
}

Rgba unpack(std::uint32_t pixel) {
    const auto part = [pixel](unsigned shift) {
        return static_cast<float>(pixel >> shift & 0xFFU);
    };
    return {part(16), part(8), part(0), part(24)};
}

// Source over destination, neither multiplied by its alpha.
std::uint32_t over(Rgba source, std::uint32_t below) {
    if (source.a < 0.5F) return below;
    if (below >> 24U == 0 || source.a >= 254.5F) return pack(source);
    const Rgba under = unpack(below);
    const float kept = under.a * (1 - source.a / 255);
    const float alpha = source.a + kept;
    Rgba mixed = (1 / alpha) * (source.a * source + kept * under);
    mixed.a = alpha;
    return pack(mixed);
}

bool same(SDL_Color a, SDL_Color b) {
    return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
}

// One colour over pixels that are mostly empty still: the inside of large shapes.
void fill(std::uint32_t* from, const std::uint32_t* to, Rgba colour) {
    const std::uint32_t packed = pack(colour);
    for (; from != to; ++from)
        *from = *from == 0 ? packed : over(colour, *from);
}

}  // namespace

void Rasterizer::resize(int width, int height) {
    layer_ = Image(width, height);
    extents_.assign(static_cast<std::size_t>(height), Extent{});
}

void Rasterizer::draw(const Mesh& mesh) {
    const auto vertex = [&mesh](std::size_t i) -> const SDL_Vertex& {
        return mesh.vertices[static_cast<std::size_t>(mesh.indices[i])];
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        draw_triangle(vertex(i), vertex(i + 1), vertex(i + 2));
}

void Rasterizer::draw_triangle(const SDL_Vertex& a, const SDL_Vertex& b, const SDL_Vertex& c) {
    if (!is_finite(a.position) || !is_finite(b.position) || !is_finite(c.position)) return;
    const Fixed p = to_fixed(a.position);
    Fixed q = to_fixed(b.position);
    Fixed r = to_fixed(c.position);
    const std::int64_t area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (area == 0) return;
    if (area < 0) std::swap(q, r);
    const std::array<Edge, 3> edges{Edge(p, q), Edge(q, r), Edge(r, p)};
    const auto [top, bottom] = std::minmax({p.y, q.y, r.y});
    const int first = static_cast<int>(std::max<std::int64_t>(floor_div(top, kSubpixels), 0));
    const int last =
        static_cast<int>(std::min<std::int64_t>(floor_div(bottom, kSubpixels), layer_.height - 1));
    const Gradient colour(a, b, c);
    const bool uniform = same(a.color, b.color) && same(a.color, c.color);
    for (int y = first; y <= last; ++y) {
        const Span span = span_of(edges, y, {0, layer_.width});
        if (span.from >= span.to) continue;
        std::uint32_t* row = layer_.row(y);
        if (uniform) {
            fill(row + span.from, row + span.to, colour.origin);
        } else {
            Rgba here =
                colour.at(static_cast<float>(span.from) + 0.5F, static_cast<float>(y) + 0.5F);
            for (int x = span.from; x < span.to; ++x, here = here + colour.by_x)
                row[x] = over(here, row[x]);
        }
        Extent& extent = extents_[static_cast<std::size_t>(y)];
        extent = extent.from < extent.to
                     ? Extent{std::min(extent.from, span.from), std::max(extent.to, span.to)}
                     : Extent{span.from, span.to};
    }
}

std::vector<SDL_Rect> Rasterizer::dirty_bands() const {
    std::vector<SDL_Rect> bands;
    for (int top = 0; top < layer_.height; top += kBandRows) {
        const int bottom = std::min(top + kBandRows, layer_.height);
        Extent all{layer_.width, 0};
        for (int y = top; y < bottom; ++y) {
            const Extent& row = extents_[static_cast<std::size_t>(y)];
            if (row.from < row.to) all = {std::min(all.from, row.from), std::max(all.to, row.to)};
        }
        if (all.from < all.to) bands.push_back({all.from, top, all.to - all.from, bottom - top});
    }
    return bands;
}

void Rasterizer::clear() {
    for (int y = 0; y < layer_.height; ++y) {
        Extent& extent = extents_[static_cast<std::size_t>(y)];
        if (extent.from < extent.to)
            std::fill(layer_.row(y) + extent.from, layer_.row(y) + extent.to, 0U);
        extent = {};
    }
}

}  // namespace poolhall::client
