// The named scenes show what they are named for, by every solver that they fit.

#include "protocol/codec/scene_json.hpp"
#include "protocol/tree.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace poolhall::lab {
namespace {

const std::filesystem::path kFolder = POOLHALL_SCENES;
constexpr double kSampleHz = 480;

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

Scene load(const std::string& name) {
    const auto tree =
        protocol::parse_tree(text_of(kFolder / (name + ".json")), protocol::Encoding::kJson);
    EXPECT_TRUE(tree.ok()) << name;
    const auto scene = protocol::scene_from_json(*tree);
    EXPECT_TRUE(scene.ok()) << name << ": " << scene.error().pointer << scene.error().reason;
    return *scene;
}

/// A shot, and questions about it.
struct Shot {
    Scene scene;
    ShotTrace trace;

    [[nodiscard]] std::size_t ball(std::string_view id) const {
        return find_ball(scene, id).value().value;
    }

    [[nodiscard]] bool is_of(const ShotEvent& event, std::size_t ball) const {
        const auto begin = event.balls.begin();
        return std::find(begin, begin + event.ball_count,
                         BallIndex{static_cast<std::uint16_t>(ball)}) != begin + event.ball_count;
    }

    [[nodiscard]] std::vector<ShotEvent> events(EventKind kind, std::string_view id) const {
        std::vector<ShotEvent> found;
        for (const ShotEvent& event : trace.events) {
            if (event.kind == kind && is_of(event, ball(id))) found.push_back(event);
        }
        return found;
    }

    [[nodiscard]] std::optional<ShotEvent> first(EventKind kind, std::string_view id) const {
        const auto found = events(kind, id);
        return found.empty() ? std::nullopt : std::optional(found.front());
    }

    /// The first impact of two balls; fails if there is none, or another pair's comes before.
    [[nodiscard]] ShotEvent first_hit(std::string_view a, std::string_view b) const {
        for (const ShotEvent& event : trace.events) {
            if (event.kind != EventKind::kBallBall) continue;
            EXPECT_TRUE(is_of(event, ball(a)) && is_of(event, ball(b)))
                << "the first hit is another one";
            return event;
        }
        ADD_FAILURE() << "no hit";
        return {};
    }

    /// Of a ball right after an event.
    [[nodiscard]] Vec2 velocity_after(const ShotEvent& event, std::string_view id) const {
        return xy(event.after[event.balls[0].value == ball(id) ? 0 : 1].v);
    }

    /// With what velocity the ball rolls on from its first hit.
    [[nodiscard]] Vec2 rolls_on(std::string_view id) const {
        const double hit = first_hit("cue", "object").t;
        for (const ShotEvent& event : events(EventKind::kSlideToRoll, id)) {
            if (event.t > hit) return xy(event.after[0].v);
        }
        ADD_FAILURE() << "does not roll";
        return {};
    }
};

using Check = std::function<void(const Shot&)>;

void rack_opens(const Shot& shot) {
    std::size_t to_rails = 0;
    for (std::size_t i = 1; i < shot.scene.balls.size(); ++i) {
        EXPECT_GT(norm(shot.trace.balls[i].state.r - shot.scene.balls[i].state.r), 1e-4) << i;
        if (shot.first(EventKind::kBallRail, shot.scene.balls[i].id)) ++to_rails;
    }
    EXPECT_GE(to_rails, 4U) << "not a legal break";
    EXPECT_LT(shot.trace.events.size(), 500U);
}

void last_ball_leaves(const Shot& shot) {
    const auto hits = shot.events(EventKind::kBallBall, "4");
    ASSERT_FALSE(hits.empty());
    const double in = xy(shot.first_hit("cue", "1").before[0].v).x;
    EXPECT_NEAR(shot.velocity_after(hits[0], "4").x, in, 1e-13);
    for (const char* id : {"cue", "1", "2", "3"}) {
        for (const ShotEvent& event : shot.events(EventKind::kBallBall, id)) {
            if (event.t > hits[0].t) break;
            if (!shot.is_of(event, shot.ball("4")) || event.t < hits[0].t) continue;
            EXPECT_EQ(norm(shot.velocity_after(event, id)), 0) << id;
        }
    }
}

void mirrors(const Shot& shot) {
    const auto mirror = [](const BallState& a, const BallState& b) {
        return a.r.x == b.r.x && a.r.y == -b.r.y && a.v.x == b.v.x && a.v.y == -b.v.y;
    };
    EXPECT_TRUE(mirror(shot.trace.balls[1].state, shot.trace.balls[2].state));
    EXPECT_EQ(shot.trace.balls[0].state.r.y, 0);
    const auto left = shot.first(EventKind::kBallBall, "left");
    const auto right = shot.first(EventKind::kBallBall, "right");
    ASSERT_TRUE(left && right);
    EXPECT_EQ(left->t, right->t);
    const double in = left->before[0].v.x;
    EXPECT_NEAR(shot.velocity_after(*right, "cue").x, -in / 5, 1e-13);
}

void cuts_thinly(const Shot& shot) {
    const ShotEvent hit = shot.first_hit("cue", "object");
    const Vec2 object = shot.velocity_after(hit, "object");
    EXPECT_GT(std::abs(object.y), 2.7 * std::abs(object.x)) << "less than 70 degrees";
    EXPECT_GT(norm(shot.velocity_after(hit, "cue")), 0.95 * norm(xy(hit.before[0].v)));
}

void is_thrown(const Shot& shot) {
    const ShotEvent hit = shot.first_hit("cue", "object");
    const Vec2 line = xy(hit.before[1].r) - xy(hit.before[0].r);
    const Vec2 object = shot.velocity_after(hit, "object");
    const double sine = cross(line, object) / (norm(line) * norm(object));
    EXPECT_GT(sine, 0.01) << "towards where the cue ball goes on";
    EXPECT_LT(sine, 0.1);
}

void banks(const Shot& shot) {
    const auto rail = shot.first(EventKind::kBallRail, "object");
    const auto pocket = shot.first(EventKind::kBallPocket, "object");
    ASSERT_TRUE(rail && pocket);
    EXPECT_EQ(rail->rail, Rail::kNorth);
    EXPECT_EQ(pocket->pocket, Pocket::kSouth);
}

void kicks(const Shot& shot) {
    const auto rail = shot.first(EventKind::kBallRail, "cue");
    ASSERT_TRUE(rail);
    EXPECT_LT(rail->t, shot.first_hit("cue", "object").t);
}

void curves(const Shot& shot) {
    const ShotEvent hit = shot.first_hit("cue", "object");
    const auto strike = shot.first(EventKind::kStrike, "cue");
    EXPECT_GT(strike->after[0].v.y, 0.3);
    EXPECT_LT(hit.before[0].v.y, -0.1) << "comes back to the line";
    double highest = 0;
    for (std::size_t k = 0; k < shot.trace.sample_count(); ++k) {
        if (static_cast<double>(k) / kSampleHz < hit.t)
            highest = std::max(highest, shot.trace.sample(k, 0).y);
    }
    EXPECT_GT(highest, 2 * shot.scene.ball.radius) << "past the blocker";
}

void flies_over(const Shot& shot) {
    const ShotEvent hit = shot.first_hit("cue", "object");
    const double blocker = shot.scene.balls[shot.ball("blocker")].state.r.x;
    bool seen = false;
    for (std::size_t k = 0; k < shot.trace.sample_count(); ++k) {
        const Vec3& r = shot.trace.sample(k, 0);
        if (static_cast<double>(k) / kSampleHz > hit.t) break;
        if (std::abs(r.x - blocker) > 0.005) continue;
        seen = true;
        EXPECT_GT(r.z, 2 * shot.scene.ball.radius);
    }
    EXPECT_TRUE(seen);
}

void stays_along_the_rail(const Shot& shot) {
    const double y = shot.scene.balls[0].state.r.y;
    for (const ShotEvent& event : shot.trace.events) {
        EXPECT_EQ(event.after[0].r.y, y);
        EXPECT_FALSE(event.kind == EventKind::kBallRail && event.rail == Rail::kNorth);
    }
    EXPECT_EQ(shot.trace.balls[0].state.r.y, y);
    EXPECT_GT(shot.trace.balls[0].state.r.x - shot.scene.balls[0].state.r.x, -1);
}

void rattles(const Shot& shot) {
    std::size_t jaws = 0;
    for (const ShotEvent& event : shot.events(EventKind::kBallRail, "cue")) {
        if (event.rail == Rail::kNorthEastJawN || event.rail == Rail::kNorthEastJawE) ++jaws;
    }
    EXPECT_GE(jaws, 2U);
    EXPECT_EQ(shot.trace.balls[0].motion, Motion::kStationary);
}

void few_events(const Shot& shot) {
    EXPECT_LE(shot.trace.events.size(), 20U);
    EXPECT_FALSE(shot.events(EventKind::kBallBall, "cue").empty());
}

void squirts(const Shot& shot) {
    const Vec3 v = shot.first(EventKind::kStrike, "cue")->after[0].v;
    EXPECT_GT(v.y / v.x, 0.02);
    EXPECT_LT(v.y / v.x, 0.1);
}

void turns_aside(const Shot& shot) {
    const auto rail = shot.first(EventKind::kBallRail, "cue");
    ASSERT_TRUE(rail);
    EXPECT_EQ(rail->before[0].v.x, 0);
    EXPECT_GT(rail->after[0].v.x, 0.2) << "right english, seen from the cue";
}

/// All solvers but `overlap` at the scene's 30 Hz.
void hits_or_shows_the_miss(const Shot& shot) {
    const auto hit = shot.first(EventKind::kBallBall, "cue");
    if (shot.scene.solver.kind == SolverKind::kOverlap) {
        EXPECT_TRUE(!hit || hit->t > 0.1);
        return;
    }
    ASSERT_TRUE(hit);
    EXPECT_NEAR(norm(hit->before[0].r - hit->before[1].r), 2 * shot.scene.ball.radius, 1e-12);
    EXPECT_LT(hit->t, 0.04);
}

struct Shown {
    Check check;
    bool by_overlap = true;  ///< whether the overlap test at the end of a tick is good enough
    double hz_factor = 1;    ///< of the ticks a second of the list below
};

const std::map<std::string, Shown> kShown{
    {"bank", {banks}},
    {"break_15_balls", {rack_opens}},
    {"break_9_ball", {rack_opens}},
    {"cradle", {last_ball_leaves, false}},
    {"double_hit", {mirrors, false}},
    {"draw", {[](const Shot& shot) { EXPECT_LT(shot.rolls_on("cue").x, -0.3); }}},
    {"end_game", {[](const Shot& shot) { (void)shot.first_hit("cue", "8"); }}},
    {"english", {turns_aside}},
    {"fast_and_thin", {hits_or_shows_the_miss, true, 0}},
    {"follow", {[](const Shot& shot) { EXPECT_GT(shot.rolls_on("cue").x, 0.3); }}},
    {"frozen_to_rail", {stays_along_the_rail}},
    {"jaw_rattle", {rattles}},
    {"jump", {flies_over}},
    {"kick", {kicks}},
    {"masse", {curves}},
    {"slow_chase", {few_events, false}},
    {"squirt", {squirts}},
    {"stun", {[](const Shot& shot) { EXPECT_LT(norm(shot.rolls_on("cue")), 0.1); }}},
    {"thin_cut", {cuts_thinly}},
    {"throw", {is_thrown}},
};

class NamedScene : public ::testing::TestWithParam<std::string> {};

std::vector<std::string> names() {
    std::vector<std::string> names;
    names.reserve(kShown.size());
    for (const auto& [name, shown] : kShown)
        names.push_back(name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, NamedScene, ::testing::ValuesIn(names()),
                         [](const auto& name) { return name.param; });

TEST_P(NamedScene, ShowsWhatItIsNamedForByEverySolverThatItFits) {
    const Shown& shown = kShown.at(GetParam());
    Shot shot{load(GetParam()), {}};
    const SolverSpec own = shot.scene.solver;
    int fitting = 0;
    for (const SolverSpec solver : {own,
                                    SolverSpec{SolverKind::kEvent, 30},
                                    {SolverKind::kExactArc, 120},
                                    {SolverKind::kSemiImplicit, 960},
                                    {SolverKind::kEuler, 1920},
                                    {SolverKind::kOverlap, 19200}}) {
        shot.scene.solver = solver;
        if (shown.hz_factor == 0) shot.scene.solver.hz = own.hz;
        if (check(shot.scene) || (solver.kind == SolverKind::kOverlap && !shown.by_overlap))
            continue;
        ++fitting;
        SCOPED_TRACE(std::string(name(solver.kind)));
        simulate(shot.scene, kSampleHz, shot.trace);
        EXPECT_EQ(shot.trace.outcome, Outcome::kRest);
        shown.check(shot);
    }
    EXPECT_GE(fitting, 5);
}

TEST(SceneFolder, HasATestAndALineOfTheReadmeForEachScene) {
    const std::string readme = text_of(kFolder / "README.md");
    std::size_t scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
        if (entry.path().extension() != ".json") continue;
        ++scenes;
        const std::string name = entry.path().stem().string();
        EXPECT_TRUE(kShown.contains(name)) << name;
        EXPECT_NE(readme.find("| `" + name + "` |"), std::string::npos) << name;
        EXPECT_EQ(load(name).id, name);
    }
    EXPECT_EQ(scenes, kShown.size());
}

}  // namespace
}  // namespace poolhall::lab
