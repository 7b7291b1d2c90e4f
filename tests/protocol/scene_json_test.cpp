#include "protocol/codec/scene_json.hpp"

#include "shared/physics/effects/presets.hpp"
#include "shared/table/presets.hpp"
#include "tests/protocol/random_messages.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

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
                    "sliding": {"mu": 0.3}, "rolling": {"mu": 0.02}, "spin_decay": {"mu": 0.04},
                    "ball_ball": {"model": "friction", "e": 0.9, "mu": 0.07,
                                  "friction_by_speed": {"a": 0.01, "b": 0.1, "c": 1},
                                  "min_separation": 0.001},
                    "rail": {"model": "han2005", "e": 0.85, "mu": 0.25, "nose_height": 0.035},
                    "airborne": {"e_slate": 0.6}},
        "solver": {"kind": "euler", "hz": 60},
        "balls": [{"id": "cue", "r": [-0.5, 0]},
                  {"id": "8", "r": [0.5, 0.25, 0.1], "v": [0.1, 0], "w": [0, 0, 1],
                   "radius": 0.03, "mass": 0.2}],
        "limits": {"time": 60, "events": 1000},
        "strike": {"ball": "cue", "direction": [1, 0.5], "speed": 2, "offset": [0.25, -0.5],
                   "elevation": 0.125, "end_mass_ratio": 0.0625}})");
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
    expected.effects.sliding = SlidingSpec{0.3};
    expected.effects.rolling = RollingSpec{0.02};
    expected.effects.spin_decay = SpinDecaySpec{0.04};
    expected.effects.ball_ball = {BallBallModel::kFriction, 0.9, 0.07,
                                  FrictionBySpeed{0.01, 0.1, 1}, 0.001};
    expected.effects.rail = {RailModel::kHan2005, 0.85, 0.25, 0.035};
    expected.effects.airborne = AirborneSpec{0.6};
    expected.solver = {SolverKind::kEuler, 60};
    expected.balls = {{"cue", {{-0.5, 0, 0}, {}, {}}},
                      {"8", {{0.5, 0.25, 0.1}, {0.1, 0, 0}, {0, 0, 1}}, 0.03, 0.2}};
    expected.limits = {60, 1000};
    expected.strike = Strike{BallIndex{0}, {1, 0.5}, 2, {0.25, -0.5}, 0.125, 0.0625};
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

TEST(SceneJson, TakesAnEffectsCoefficientsFromItsDefaults) {
    Json json = whole_scene();
    json["effects"] = Json::parse(
        R"({"sliding": {}, "rolling": {}, "spin_decay": {}, "airborne": {},
            "ball_ball": {"model": "friction", "friction_by_speed": {}}, "rail": {"model": "han2005"}})");
    const auto scene = scene_from_json(json);
    ASSERT_TRUE(scene.ok()) << scene.error().pointer << " " << scene.error().reason;
    Effects expected;
    expected.sliding = SlidingSpec{};
    expected.rolling = RollingSpec{};
    expected.spin_decay = SpinDecaySpec{};
    expected.airborne = AirborneSpec{};
    expected.ball_ball = BallBallSpec{};
    expected.ball_ball.friction_by_speed = FrictionBySpeed{};
    expected.rail = RailSpec{RailModel::kHan2005};
    EXPECT_EQ(scene->effects, expected);
}

TEST(SceneJson, ARailWithoutANoseIsTheSameWhetherItIsNamedOrNot) {
    Json json = whole_scene();
    json["effects"] = {{"sliding", Json::object()}, {"airborne", Json::object()}};
    const auto unnamed = scene_from_json(json);
    json["effects"]["rail"] = {{"model", "elastic"}};
    const auto named = scene_from_json(json);
    ASSERT_TRUE(unnamed.ok() && named.ok());
    EXPECT_EQ(*named, *unnamed);
    json["effects"]["rail"] = {{"model", "restitution"}, {"e", 0.9}};
    RailSpec rail = RailPart{}.rail;
    rail.model = RailModel::kRestitution;
    rail.e = 0.9;
    EXPECT_EQ(scene_from_json(json)->effects.rail, rail);
}

TEST(SceneJson, ReadsPocketsAsAListOfCircles) {
    Json json = whole_scene();
    json["table"]["pockets"] = Json::parse(
        R"([{"id": "NE", "x": 1.27, "y": 0.635, "radius": 0.06},
            {"id": "left", "x": -1, "y": "0x1p-2", "radius": "0x1p-5"}])");
    const auto scene = scene_from_json(json);
    ASSERT_TRUE(scene.ok()) << scene.error().pointer << " " << scene.error().reason;
    EXPECT_EQ(scene->table.pockets, PocketModel::kCircles);
    EXPECT_EQ(scene->table.circles, (std::vector<PocketCircle>{{"NE", {1.27, 0.635}, 0.06},
                                                               {"left", {-1, 0.25}, 0.03125}}));
    EXPECT_EQ(*scene_from_json(to_json(*scene)), *scene);
}

TEST(SceneJson, RefusesCirclesAtTheirPlace) {
    const Json circle{{"id", "a"}, {"x", 1}, {"y", 0.5}, {"radius", 0.05}};
    const std::string at = "/table/pockets";
    expect_refused(at, 3, at, "must be a string or an array of circles");
    expect_refused(at, {circle, circle}, at + "/1/id", "is the same as /table/pockets/0/id");
    expect_refused(at, Json(65, circle), at, "must have 0 to 64 elements");
    expect_refused(at, Json::array({Json{{"id", "a"}, {"x", 1}, {"y", 0.5}}}), at + "/0/radius",
                   "is missing");
    Json flat = circle;
    flat["radius"] = 0;
    expect_refused(at, Json::array({flat}), at + "/0/radius",
                   "must be positive and within its bounds");
}

TEST(SceneJson, ReadsAnElevatedCueFromADirectionThatFalls) {
    Json json = whole_scene();
    json["strike"].erase("elevation");
    json["strike"]["direction"] = {3, 4, -10};
    const auto scene = scene_from_json(json);
    ASSERT_TRUE(scene.ok()) << scene.error().pointer << " " << scene.error().reason;
    EXPECT_EQ(scene->strike->direction, (Vec2{3, 4}));
    EXPECT_EQ(scene->strike->elevation, 2);
    json["strike"]["elevation"] = 0;
    EXPECT_EQ(scene_from_json(json)->strike->elevation, 2) << "0 is as good as left out";
    json["strike"]["direction"] = {3, 4, -0.0};
    EXPECT_EQ(scene_from_json(json)->strike->elevation, 0);
}

TEST(SceneJson, RefusesDirectionsThatRiseOrSayTwoThings) {
    const std::string at = "/strike/direction";
    expect_refused(at, {3, 4, 1}, at, "must not point upwards");
    expect_refused(at, {3, 4, -1}, "/strike/elevation",
                   "must not be given besides a direction that falls");
    expect_refused("/strike", {{"ball", "cue"}, {"direction", {0, 0, -1}}, {"speed", 1}}, at,
                   "must not point straight down");
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
    expect_refused("/table/pockets", "mouths", "/table/pockets",
                   "must be one of none, end_game, pool");
    expect_refused("/balls", Json::object(), "/balls", "must be an array");
    expect_refused("/balls/0", 1, "/balls/0", "must be an object");
    expect_refused("/balls/0/r", {1}, "/balls/0/r", "must have 2 to 3 elements");
    expect_refused("/balls/1/w", {1, 2}, "/balls/1/w", "must have 3 elements");
    expect_refused("/balls/0/id", "", "/balls/0/id", "must be 1 to 64 bytes of UTF-8");
    expect_refused("/balls/0/id", 8, "/balls/0/id", "must be a string");
    expect_refused("/strike/direction", {1}, "/strike/direction", "must have 2 to 3 elements");
    expect_refused("/strike/offset", {1, 0, 0}, "/strike/offset", "must have 2 elements");
}

TEST(SceneJson, RefusesWhatIsNotSimulated) {
    expect_refused("/effects/wind", {{"mu", 0.2}}, "/effects/wind", "is not known");
    expect_refused("/effects/ball_ball/model", "sticky", "/effects/ball_ball/model",
                   "must be one of elastic, restitution, friction, mathavan2014");
    expect_refused("/effects/rail/model", "stronge", "/effects/rail/model",
                   "must be one of elastic, restitution, han2005, mathavan2010, mathavan2010_fast");
    expect_refused("/effects/sliding/nu", 0.2, "/effects/sliding/nu", "is not known");
    expect_refused("/solver/kind", "rk4", "/solver/kind",
                   "must be one of euler, overlap, semi_implicit, exact_arc, event");
    expect_refused("/strike/angle", 0.1, "/strike/angle", "is not known");
    expect_refused("/color", "green", "/color", "is not known");
    expect_refused("/balls/1/colour", "black", "/balls/1/colour", "is not known");
}

TEST(SceneJson, RefusesWhatCheckRefuses) {
    expect_refused("/schema", "poolhall.scene/2", "/schema", "must be \"poolhall.scene/1\"");
    expect_refused("/strike/ball", "9", "/strike/ball", "must be the id of a ball");
    expect_refused("/strike/direction", {0, 0}, "/strike/direction", "must not be zero");
    expect_refused("/balls/1/id", "cue", "/balls/1/id", "is the same as /balls/0/id");
    expect_refused("/balls/1/r", {-0.5, 0.01}, "/balls/1/r", "overlaps /balls/0");
    expect_refused("/strike/offset", {0.8, 0.6}, "/strike/offset",
                   "must be shorter than 1, or the tip misses the ball");
    expect_refused("/solver/kind", "event", "/solver/kind",
                   "has no closed form of linear_drag together with sliding or rolling");
}

TEST(SceneJson, TakesTablesBallsAndEffectsFromPresets) {
    Json json = whole_scene();
    json["table"] = {{"preset", "12ft_snooker"}};
    json["ball"] = {{"preset", "snooker"}};
    json["effects"] = {{"preset", "snooker"}};
    json["balls"][1].erase("radius");
    json["solver"] = {{"kind", "event"}};
    const auto scene = scene_from_json(json);
    ASSERT_TRUE(scene.ok()) << scene.error().pointer << " " << scene.error().reason;
    EXPECT_EQ(scene->table, preset_value(TablePreset::kTwelveFootSnooker));
    EXPECT_EQ(scene->ball, preset_value(BallSet::kSnooker));
    EXPECT_EQ(scene->effects, preset_value(EffectsPreset::kSnooker));
    EXPECT_EQ(*scene_from_json(to_json(*scene)), *scene);
}

TEST(SceneJson, LetsFieldsBesideAPresetOverrideIt) {
    Json json = whole_scene();
    json["table"] =
        Json::parse(R"({"preset": "9ft_pro", "mouths": {"corner": {"jaw_radius": 0.02095}}})");
    json["effects"] = Json::parse(R"({"preset": "worsted", "rolling": {"mu": 0.008},
                                      "sliding": null, "rail": {"e_by_speed": null}})");
    json["balls"][1]["r"] = {0.5, 0.25};
    const auto scene = scene_from_json(json);
    ASSERT_TRUE(scene.ok()) << scene.error().pointer << " " << scene.error().reason;
    Table table = preset_value(TablePreset::kNineFootPro);
    table.mouths->corner.jaw_radius = 0.02095;
    EXPECT_EQ(scene->table, table);
    Effects effects = preset_value(EffectsPreset::kWorsted);
    effects.rolling->mu = 0.008;
    effects.sliding.reset();
    effects.rail.e_by_speed.reset();
    EXPECT_EQ(scene->effects, effects);
}

TEST(SceneJson, GivesABarTablesCueBallToTheBallOfThatName) {
    Json json = whole_scene();
    json["ball"] = {{"preset", "bar_large"}};
    json["balls"][1].erase("radius");
    const auto scene = scene_from_json(json);
    ASSERT_TRUE(scene.ok()) << scene.error().pointer << " " << scene.error().reason;
    const BallSpec cue = *cue_ball_of(BallSet::kBarLarge);
    EXPECT_EQ(scene->balls[0].radius, cue.radius);
    EXPECT_EQ(scene->balls[0].mass, cue.mass);
    EXPECT_EQ(scene->balls[1].radius, std::nullopt);
    json["balls"][0]["mass"] = 0.2;
    EXPECT_EQ(scene_from_json(json)->balls[0].mass, 0.2);
}

TEST(SceneJson, RefusesWhatNoPresetIsCalledAndFieldsBesideItThatAreNone) {
    expect_refused("/table", {{"preset", "10ft"}}, "/table/preset",
                   "must be one of 9ft, 9ft_pro, 8ft, 8ft_home, 7ft_bar, 12ft_snooker, 10ft_carom");
    expect_refused("/ball", {{"preset", 8}}, "/ball/preset", "must be a string");
    expect_refused("/effects", {{"preset", "bar"}, {"wind", 1}}, "/effects/wind", "is not known");
    expect_refused("/table", {{"preset", "9ft"}, {"length", nullptr}}, "/table/length",
                   "is missing");
    expect_refused("/table", {{"preset", "9ft"}, {"rails", 1}}, "/table/rails",
                   "must be true or false");
}

TEST(SceneJson, RefusesMissingFields) {
    for (const char* at :
         {"/schema", "/table", "/table/length", "/table/width", "/ball/radius", "/ball/mass",
          "/effects", "/effects/linear_drag/k", "/effects/linear_drag/stop_speed", "/solver",
          "/solver/kind", "/balls", "/balls/0/id", "/balls/0/r", "/strike/ball",
          "/strike/direction", "/strike/speed"}) {
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

}  // namespace
}  // namespace poolhall::protocol
