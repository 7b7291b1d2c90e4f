#include "protocol/codec/result_json.hpp"

#include "protocol/text.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/protocol/random_messages.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

namespace poolhall::protocol {
namespace {

using Json = nlohmann::ordered_json;

/// A hit and a pocketed ball.
Scene shot() {
    Scene scene;
    scene.id = "a shot";
    scene.table.pockets = PocketModel::kCircles;
    scene.table.circles = {{"foot", {1.2, 0}, 0.05}};
    scene.effects.rolling = RollingSpec{};
    scene.solver.kind = SolverKind::kEvent;
    scene.balls = {{"cue", {{-0.5, 0, 0}, {}, {}}}, {"8", {{0.5, 0, 0}, {}, {}}}};
    scene.strike = Strike{BallIndex{0}, {1, 0}, 2};
    return scene;
}

std::string text_of(const ShotTrace& trace, const Scene& scene, const ResultForm& form = {}) {
    std::ostringstream out;
    write_result(out, trace, scene, form);
    return out.str();
}

TEST(ResultJson, TellsAShotInTheDocumentedOrder) {
    const Scene scene = shot();
    const ShotTrace trace = simulate(scene, 30);
    const std::string text = text_of(trace, scene, {.cost_ns = 123});
    EXPECT_EQ(text.find('\n'), std::string::npos);
    const Json result = Json::parse(text);
    std::string keys;
    for (const auto& item : result.items())
        keys += item.key() + " ";
    EXPECT_EQ(keys,
              "schema id solver kernel effects hash duration outcome events balls cost samples ");
    EXPECT_EQ(result["schema"], "poolhall.result/1");
    EXPECT_EQ(result["id"], "a shot");
    EXPECT_EQ(result["solver"], "event");
    EXPECT_EQ(result["kernel"], trace.kernel);
    EXPECT_EQ(result["hash"], to_hex(trace.hash));
    EXPECT_EQ(result["duration"], trace.duration);
    EXPECT_EQ(result["outcome"], "rest");
    EXPECT_EQ(result["cost"],
              (Json{{"ns", 123}, {"ticks", trace.ticks}, {"events", trace.events.size()}}));
}

TEST(ResultJson, TellsEventsBallsAndSamples) {
    const Scene scene = shot();
    const ShotTrace trace = simulate(scene, 30);
    const Json result = Json::parse(text_of(trace, scene));
    ASSERT_EQ(result["events"].size(), trace.events.size());
    for (std::size_t i = 0; i < trace.events.size(); ++i)
        EXPECT_EQ(result["events"][i], to_json(trace.events[i], scene));
    ASSERT_EQ(result["balls"].size(), 2U);
    EXPECT_EQ(result["balls"][0]["id"], "cue");
    EXPECT_EQ(result["balls"][0]["motion"], "stationary");
    EXPECT_FALSE(result["balls"][0].contains("pocket"));
    EXPECT_EQ(result["balls"][1]["motion"], "pocketed");
    EXPECT_EQ(result["balls"][1]["pocket"], "foot");
    ASSERT_EQ(result["samples"].size(), trace.sample_count());
    EXPECT_EQ(result["samples"][0]["t"], 0);
    EXPECT_EQ(result["samples"][0]["r"][0], Json::array({-0.5, 0.0, 0.0}));
    EXPECT_FALSE(result.contains("cost"));
}

/// The doubles of a tree in their order; in hex form, the strings that stand for them.
std::vector<double> numbers_of(const Json& tree) {
    if (tree.is_number_float()) return {tree.get<double>()};
    if (tree.is_string()) {
        const auto number = parse_hex_float(tree.get<std::string>());
        return number ? std::vector{*number} : std::vector<double>{};
    }
    std::vector<double> numbers;
    if (!tree.is_structured()) return numbers;
    for (const Json& part : tree) {
        const auto more = numbers_of(part);
        numbers.insert(numbers.end(), more.begin(), more.end());
    }
    return numbers;
}

TEST(ResultJson, HexFormHasTheSameBits) {
    const Scene scene = shot();
    const ShotTrace trace = simulate(scene, 30);
    const Json decimal = Json::parse(text_of(trace, scene));
    const Json hex = Json::parse(text_of(trace, scene, {.numbers = Numbers::kHexFloat}));
    const auto expected = numbers_of(decimal);
    const auto actual = numbers_of(hex);
    ASSERT_GT(expected.size(), 100U);
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(actual[i], expected[i]);
        EXPECT_EQ(std::signbit(actual[i]), std::signbit(expected[i]));
    }
    EXPECT_EQ(hex["duration"], to_hex_float(trace.duration));
}

TEST(ResultJson, NamesTheBallsOfAnEvent) {
    const Scene scene = shot();
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

TEST(ResultJson, NamesRailsAndJaws) {
    ShotEvent event;
    event.kind = EventKind::kBallRail;
    event.rail = Rail::kNorthEastJawN;
    EXPECT_EQ(to_json(event, shot())["rail"], "NE.N");
}

}  // namespace
}  // namespace poolhall::protocol
