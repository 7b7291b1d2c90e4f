#include "protocol/scene_json.hpp"

#include "shared/physics/simulate.hpp"
#include "tests/protocol/random_messages.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

namespace poolhall::protocol {
namespace {

using Json = nlohmann::ordered_json;

/// A scene with every field, as a person would write it.
Json whole_scene() {
    return Json::parse(R"({
        "schema": "poolhall.scene/1", "id": "whole",
        "table": {"length": 2.54, "width": 1.27, "rails": true, "pockets": "end_game"},
        "ball": {"radius": 0.028575, "mass": 0.170097},
        "gravity": 9.81,
        "effects": {"linear_drag": {"k": 0.6, "stop_speed": 0.0625},
                    "ball_ball": {"model": "elastic"},
                    "rail": {"model": "restitution", "e": 0.85}},
        "solver": {"kind": "euler", "hz": 60},
        "balls": [{"id": "cue", "r": [-0.5, 0]},
                  {"id": "8", "r": [0.5, 0.25, 0], "v": [0.1, 0], "w": [0, 0, 1]}],
        "limits": {"time": 60, "events": 1000},
        "strike": {"ball": "cue", "direction": [1, 0.5], "speed": 2}})");
}

/// Puts a value at a pointer (or removes it, for a discarded value) and expects a refusal.
void expect_refused(const std::string& at, const Json& value, const std::string& pointer,
                    const std::string& reason) {
    Json scene = whole_scene();
    scene[Json::json_pointer(at)] = value;
    const auto result = scene_from_json(scene);
    ASSERT_FALSE(result.ok()) << at << " = " << value;
    EXPECT_EQ(result.error().pointer, pointer) << value;
    EXPECT_EQ(result.error().reason, reason) << value;
}

TEST(SceneJson, ReadsEveryField) {
    const auto scene = scene_from_json(whole_scene());
    ASSERT_TRUE(scene.ok()) << scene.error().pointer << " " << scene.error().reason;
    Scene expected;
    expected.id = "whole";
    expected.table = {2.54, 1.27, true, PocketModel::kEndGame};
    expected.effects.linear_drag = LinearDragSpec{0.6, 0.0625};
    expected.effects.rail = {RailModel::kRestitution, 0.85};
    expected.solver = {SolverKind::kEuler, 60};
    expected.balls = {{"cue", {{-0.5, 0, 0}, {}, {}}},
                      {"8", {{0.5, 0.25, 0}, {0.1, 0, 0}, {0, 0, 1}}}};
    expected.limits = {60, 1000};
    expected.strike = Strike{BallIndex{0}, {1, 0.5}, 2};
    EXPECT_EQ(*scene, expected);
}

TEST(SceneJson, ReadsTheLeastThatIsAScene) {
    const auto scene = scene_from_json(Json::parse(
        R"({"schema": "poolhall.scene/1", "table": {"length": 3, "width": 2}, "effects": {},
            "solver": {"kind": "overlap"}, "balls": []})"));
    ASSERT_TRUE(scene.ok()) << scene.error().pointer << " " << scene.error().reason;
    Scene expected;
    expected.table = {3, 2, true, PocketModel::kNone};
    expected.solver = {SolverKind::kOverlap, 30};
    EXPECT_EQ(*scene, expected);
}

TEST(SceneJson, ComesBackEqual) {
    testing::Random random(11);
    for (int i = 0; i < 500; ++i) {
        const Scene scene = testing::random_scene(random, random.coin());
        const auto back = scene_from_json(Json::parse(to_json(scene).dump()));
        ASSERT_TRUE(back.ok()) << back.error().pointer << " " << back.error().reason;
        ASSERT_EQ(*back, scene);
    }
}

TEST(SceneJson, ConvertsFromAnUnorderedTree) {
    const nlohmann::json unordered = nlohmann::json::parse(whole_scene().dump());
    EXPECT_EQ(*scene_from_json(unordered), *scene_from_json(whole_scene()));
}

TEST(SceneJson, ReadsHexFloats) {
    Json json = whole_scene();
    json["table"]["length"] = "0x1.4p+1";
    json["balls"][0]["r"][0] = "-0x1p-1";
    json["strike"]["direction"] = {"0x1p0", "0x1p-1"};
    json["solver"]["hz"] = "0x1p5";
    const auto scene = scene_from_json(json);
    ASSERT_TRUE(scene.ok()) << scene.error().pointer;
    EXPECT_EQ(scene->table.length, 2.5);
    EXPECT_EQ(scene->balls[0].state.r.x, -0.5);
    EXPECT_EQ(scene->strike->direction, (Vec2{1, 0.5}));
    EXPECT_EQ(scene->solver.hz, 32);
}

TEST(SceneJson, RefusesNumbersAtTheirPlace) {
    const std::string not_a_number = "must be a number or a finite C hex-float string";
    expect_refused("/table/length", "2.5", "/table/length", not_a_number);
    expect_refused("/balls/1/w/2", "0x1p1024", "/balls/1/w/2", not_a_number);
    expect_refused("/balls/1/v/0", "nan", "/balls/1/v/0", not_a_number);
    expect_refused("/gravity", nullptr, "/gravity", "must be a number");
    expect_refused("/ball/mass", true, "/ball/mass", "must be a number");
    expect_refused("/limits/events", 1.5, "/limits/events", "must be an integer");
    expect_refused("/limits/events", -1, "/limits/events", "must be from 0 to 4294967295");
    expect_refused("/strike/speed", Json::array(), "/strike/speed", "must be a number");
}

TEST(SceneJson, RefusesShapesAtTheirPlace) {
    expect_refused("", Json::array(), "", "must be an object");
    expect_refused("/table", 1, "/table", "must be an object");
    expect_refused("/table/rails", "no", "/table/rails", "must be true or false");
    expect_refused("/table/pockets", "mouths", "/table/pockets", "must be one of none, end_game");
    expect_refused("/balls", Json::object(), "/balls", "must be an array");
    expect_refused("/balls/0", 1, "/balls/0", "must be an object");
    expect_refused("/balls/0/r", {1}, "/balls/0/r", "must have 2 to 3 elements");
    expect_refused("/balls/1/w", {1, 2}, "/balls/1/w", "must have 3 elements");
    expect_refused("/balls/0/id", "", "/balls/0/id", "must be 1 to 64 bytes of UTF-8");
    expect_refused("/balls/0/id", 8, "/balls/0/id", "must be a string");
    expect_refused("/strike/direction", {1, 0, 0}, "/strike/direction", "must have 2 elements");
}

TEST(SceneJson, RefusesWhatIsNotSimulated) {
    expect_refused("/effects/sliding", {{"mu", 0.2}}, "/effects/sliding", "is not known");
    expect_refused("/effects/ball_ball/model", "friction", "/effects/ball_ball/model",
                   "must be one of elastic");
    expect_refused("/effects/rail/model", "han2005", "/effects/rail/model",
                   "must be one of elastic, restitution");
    expect_refused("/effects/rail/mu", 0.2, "/effects/rail/mu", "is not known");
    expect_refused("/solver/kind", "event", "/solver/kind", "must be one of euler, overlap");
    expect_refused("/strike/elevation", 0.1, "/strike/elevation", "is not known");
    expect_refused("/color", "green", "/color", "is not known");
    expect_refused("/balls/1/colour", "black", "/balls/1/colour", "is not known");
}

TEST(SceneJson, RefusesWhatCheckRefuses) {
    expect_refused("/schema", "poolhall.scene/2", "/schema", "must be \"poolhall.scene/1\"");
    expect_refused("/strike/ball", "9", "/strike/ball", "must be the id of a ball");
    expect_refused("/strike/direction", {0, 0}, "/strike/direction", "must not be zero");
    expect_refused("/balls/1/id", "cue", "/balls/1/id", "is the same as /balls/0/id");
    expect_refused("/balls/1/r", {-0.5, 0.01}, "/balls/1/r", "overlaps /balls/0");
}

TEST(SceneJson, RefusesMissingFields) {
    for (const char* at :
         {"/schema", "/table", "/table/length", "/table/width", "/ball/radius", "/ball/mass",
          "/effects", "/effects/linear_drag/k", "/effects/linear_drag/stop_speed",
          "/effects/rail/model", "/solver", "/solver/kind", "/balls", "/balls/0/id", "/balls/0/r",
          "/strike/ball", "/strike/direction", "/strike/speed"}) {
        const Json::json_pointer pointer(at);
        Json scene = whole_scene();
        Json& parent = scene[pointer.parent_pointer()];
        parent.erase(pointer.back());
        const auto result = scene_from_json(scene);
        ASSERT_FALSE(result.ok()) << at;
        EXPECT_EQ(result.error().pointer, at);
        EXPECT_EQ(result.error().reason, "is missing");
    }
}

TEST(SceneJson, WritesItsFieldsInTheDocumentedOrder) {
    const Json json = to_json(*scene_from_json(whole_scene()));
    std::string keys;
    for (const auto& item : json.items())
        keys += item.key() + " ";
    EXPECT_EQ(keys, "schema id table ball gravity effects solver balls limits strike ");
}

TEST(ResultJson, TellsAShot) {
    const Scene scene = *scene_from_json(whole_scene());
    const ShotTrace trace = simulate(scene, 30);
    const Json result = to_json(trace, scene);
    EXPECT_EQ(result["schema"], "poolhall.result/1");
    EXPECT_EQ(result["id"], "whole");
    EXPECT_EQ(result["solver"], "euler");
    EXPECT_EQ(result["outcome"], "rest");
    EXPECT_EQ(result["hash"], to_hex(trace.hash));
    EXPECT_EQ(result["duration"], trace.duration);
    ASSERT_EQ(result["events"].size(), trace.events.size());
    ASSERT_EQ(result["balls"].size(), 2U);
    EXPECT_EQ(result["balls"][0]["id"], "cue");
    EXPECT_EQ(result["samples"].size(), trace.sample_count());
    EXPECT_EQ(result["samples"][0]["r"][0], Json::array({-0.5, 0.0, 0.0}));
}

TEST(ResultJson, NamesTheBallsOfAnEvent) {
    const Scene scene = *scene_from_json(whole_scene());
    ShotEvent event;
    event.t = 0.25;
    event.kind = EventKind::kBallBall;
    event.ball_count = 2;
    event.balls = {BallIndex{0}, BallIndex{1}};
    event.before[0].r = {1, 0, 0};
    event.before[1].r = {2, 1, 0};
    event.after = event.before;
    const Json json = to_json(event, scene);
    EXPECT_EQ(json["balls"], Json::array({"cue", "8"}));
    EXPECT_EQ(json["at"], Json::array({1.5, 0.5}));
    EXPECT_EQ(json["before"]["8"]["r"], Json::array({2.0, 1.0, 0.0}));
    EXPECT_FALSE(json.contains("rail"));
    EXPECT_FALSE(json.contains("pocket"));
}

}  // namespace
}  // namespace poolhall::protocol
