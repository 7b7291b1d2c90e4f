#include "client/lab/validate/diamonds.hpp"

#include "shared/physics/simulate.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace poolhall::lab {

namespace {

constexpr double kSightsBehindNose = 0.0937;  ///< m: 3 11/16 in
constexpr double kFirm = 3;                   ///< m/s
constexpr double kSlow = 1;                   ///< m/s

Scene on_table(const RailSpec& rail) {
    Scene scene;
    scene.effects.sliding = SlidingSpec{};
    scene.effects.rolling = RollingSpec{};
    scene.effects.spin_decay = SpinDecaySpec{};
    scene.effects.rail = rail;
    scene.solver.kind = SolverKind::kEvent;
    return scene;
}

void set_rolling(Scene& scene, Vec2 from, Vec2 v, double side) {
    const double radius = scene.ball.radius;
    const double turn = side * norm(v) / radius;
    scene.balls = {
        {"cue", {{from.x, from.y, 0}, {v.x, v.y, 0}, {-v.y / radius, v.x / radius, turn}}}};
}

std::vector<ShotEvent> rail_hits(const Scene& scene) {
    std::vector<ShotEvent> hits;
    for (const ShotEvent& event : simulate(scene).events) {
        if (event.kind == EventKind::kBallRail) hits.push_back(event);
    }
    return hits;
}

/// The origin's sight, m: the corner SW is 5.
Vec2 origin_of(const Table& table, double number) {
    const double x = table.length / 2;
    const double y = table.width / 2 + kSightsBehindNose;
    if (number > 5)
        return {-x - kSightsBehindNose, -table.width / 2 + (number - 5) * table.width / 4};
    return {-x + (5 - number) * 2 * table.length / 8, -y};
}

/// From the sight of the origin towards that of the first rail, where the ball may begin.
Scene scene_of(const RailSpec& rail, const DiamondLine& line, double side) {
    Scene scene = on_table(rail);
    const Table& table = scene.table;
    const Vec2 origin = origin_of(table, line.origin);
    const Vec2 first{table.length / 2 - line.first * table.length / 8,
                     table.width / 2 + kSightsBehindNose};
    const Vec2 way = normalized(first - origin);
    const Vec2 edge = inset(table, scene.ball.radius);
    Vec2 from = origin;
    constexpr double kStep = 0.001;  // m
    while (from.y <= -edge.y || from.x <= -edge.x)
        from = from + kStep * way;
    // Running side rolls along the first rail, north of the ball: counterclockwise.
    set_rolling(scene, from, kFirm * way, side);
    return scene;
}

/// Lengths of the table that the ball goes.
double lengths_of(const RailSpec& rail, double speed) {
    Scene scene = on_table(rail);
    scene.balls = {{"cue", {{-scene.table.length / 4, 0, 0}, {speed, 0, 0}, {}}}};
    const ShotTrace trace = simulate(scene);
    double way = 0;
    double x = scene.balls[0].state.r.x;
    for (const ShotEvent& event : trace.events) {
        way += std::abs(event.after[0].r.x - x);
        x = event.after[0].r.x;
    }
    return way / scene.table.length;
}

/// Where f, which rises, reaches `wanted` between low and high.
template <class F>
double bisect(F f, double wanted, double low, double high) {
    constexpr int kRounds = 40;
    for (int i = 0; i < kRounds; ++i) {
        const double middle = (low + high) / 2;
        (f(middle) < wanted ? low : high) = middle;
    }
    return (low + high) / 2;
}

}  // namespace

std::optional<double> third_rail(const RailSpec& rail, const DiamondLine& line, double side) {
    const Scene scene = scene_of(rail, line, side);
    const auto hits = rail_hits(scene);
    constexpr std::array kOrder{Rail::kNorth, Rail::kEast, Rail::kSouth};
    if (hits.size() < kOrder.size()) return std::nullopt;
    for (std::size_t i = 0; i < kOrder.size(); ++i) {
        if (hits[i].rail != kOrder[i]) return std::nullopt;
    }
    const Table& table = scene.table;
    return (table.length / 2 - hits[2].after[0].r.x) / (table.length / 8);
}

std::optional<double> side_for(const RailSpec& rail, const DiamondLine& line, double third) {
    constexpr double kMost = 1.5;  // of the tip at 0.6 R
    constexpr double kStep = 0.005;
    std::optional<double> best;
    double least = 0.05;
    for (double side = 0; side <= kMost; side += kStep) {
        const auto found = third_rail(rail, line, side);
        if (!found || std::abs(*found - third) >= least) continue;
        least = std::abs(*found - third);
        best = side;
    }
    return best;
}

double speed_for_lengths(const RailSpec& rail, double lengths) {
    constexpr double kFastest = 20;
    return bisect([&](double speed) { return lengths_of(rail, speed); }, lengths, 0.1, kFastest);
}

double mirror_depth(const RailSpec& rail, double incidence) {
    constexpr double kFrom = 0.5;  // m from the nose
    Scene scene = on_table(rail);
    scene.table.length = 20;
    const double y = scene.table.width / 2 - kFrom;
    set_rolling(scene, {0, y}, kSlow * Vec2{std::sin(incidence), std::cos(incidence)}, 0);
    constexpr double kHz = 2000;
    const ShotTrace trace = simulate(scene, kHz);
    const double hit = rail_hits(scene).at(0).t;
    for (std::size_t i = 1; i < trace.sample_count(); ++i) {
        const Vec3 place = trace.sample(i, 0);
        if (static_cast<double>(i) / kHz > hit && place.y <= y)
            return place.x / (2 * std::tan(incidence)) - kFrom;
    }
    return 0;
}

}  // namespace poolhall::lab
