#include "protocol/codec/codec.hpp"
#include "tests/protocol/random_messages.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace poolhall::protocol {
namespace {

using Json = nlohmann::ordered_json;

/// A random message of a kind, as a tree to spoil.
template <class Body>
Json sample(std::uint64_t seed = 1) {
    testing::Random random(seed);
    for (const ServerMessage& message : testing::random_server_messages(random)) {
        if (std::holds_alternative<Body>(message))
            return Json::parse(encode(message, Encoding::kJson));
    }
    return {};
}

void expect_refused(const Json& tree, RejectCode code, const std::string& reason) {
    const auto result = decode_server(tree.dump(), Encoding::kJson);
    ASSERT_FALSE(result.ok()) << tree;
    EXPECT_EQ(result.error().reason, reason);
    EXPECT_EQ(name(result.error().code), name(code));
}

void expect_bad(const Json& tree, const std::string& reason) {
    expect_refused(tree, RejectCode::kBadField, reason);
}

/// A rail event that is right.
Json rail_event() {
    const Json state{{"r", {0, 0, 0}}, {"v", {1, 0, 0}}, {"w", {0, 0, 0}}};
    return {{"t", 0.5},
            {"kind", "ball_rail"},
            {"balls", {0}},
            {"rail", "N"},
            {"before", Json::array({state})},
            {"after", Json::array({state})}};
}

Json frame_with(const Json& event) {
    return {{"type", "frame"},
            {"shot", 1},
            {"tick", 1},
            {"balls", Json::array()},
            {"events", Json::array({event})}};
}

TEST(DecodeServer, RefusesTheHexFloatsOfFiles) {
    Json event = rail_event();
    event["before"][0]["v"][0] = "0x1p0";
    expect_bad(frame_with(event), "field /events/0/before/0/v/0 must be a number");
    Json tree = sample<ShotStarted>();
    tree["scene"]["table"]["length"] = "0x1p1";
    expect_bad(tree, "field /scene/table/length must be a number");
}

TEST(DecodeServer, SkipsUnknownFieldsEverywhere) {
    Json tree = sample<TableChanged>();
    const auto expected = decode_server(tree.dump(), Encoding::kJson);
    ASSERT_TRUE(expected.ok()) << expected.error().reason;
    tree["later"] = {1, 2, 3};
    tree["table"]["later"] = nullptr;
    tree["table"]["seats"][0]["later"] = "x";
    tree["table"]["state"]["scene"]["effects"]["later"] = {{"mu", 0.2}};
    const auto result = decode_server(tree.dump(), Encoding::kJson);
    ASSERT_TRUE(result.ok()) << result.error().reason;
    EXPECT_EQ(*result, *expected);
}

TEST(DecodeServer, RefusesUnknownAndClientMessages) {
    expect_refused({{"type", "later"}}, RejectCode::kUnknownType,
                   "field /type is none that is known here");
    expect_refused({{"type", "ping"}, {"seq", 1}}, RejectCode::kUnknownType,
                   "field /type is none that is known here");
}

TEST(DecodeServer, RefusesScenesThatCannotBe) {
    Json tree = sample<TableChanged>();
    tree["table"]["state"]["scene"]["solver"]["hz"] = 1e300;
    expect_bad(tree,
               "field /table/state/scene/solver/hz must be a finite number within its bounds");
    tree = sample<ShotStarted>();
    tree["scene"]["balls"][0]["r"] = {100, 0, 0};
    expect_bad(tree, "field /scene/balls/0/r is off the table");
    tree = sample<ShotStarted>();
    tree["scene"].erase("strike");
    expect_refused(tree, RejectCode::kMissingField, "field /scene/strike is missing");
}

TEST(DecodeServer, RefusesATableThatDoesNotAgreeWithItself) {
    Json tree = sample<TableChanged>();
    tree["table"]["state"]["cue_ball"] = tree["table"]["state"]["scene"]["balls"].size();
    expect_bad(tree, "field /table/state/cue_ball must be the index of a ball of the scene");
    tree = sample<TableChanged>();
    tree["table"]["live"] = {{"shot", 1}, {"tick", 1}, {"balls", Json::array()}};
    expect_bad(tree, "field /table/live/balls must have one position for each ball of the scene");
    tree = sample<TableChanged>();
    tree["table"]["seats"].erase(0);
    expect_bad(tree, "field /table/seats must have 2 elements");
    tree = sample<TableChanged>();
    tree["table"]["phase"] = "resting";
    expect_bad(tree, "field /table/phase must be one of waiting, aiming, playing, over");
}

TEST(DecodeServer, RefusesAStateThatIsNoneBetweenTwoMoves) {
    const auto expect_bad_state = [](const std::function<void(Json&)>& spoil,
                                     const std::string& reason) {
        Json tree = sample<TableChanged>();
        spoil(tree["table"]["state"]);
        expect_bad(tree, "field /table/state" + reason);
    };
    expect_bad_state(
        [](Json& state) {
            state["scene"]["strike"] = {{"ball", "cue"}, {"direction", {1, 0}}, {"speed", 1}};
        },
        "/scene/strike must not be there at rest");
    expect_bad_state(
        [](Json& state) {
            state["over"] = false;
            state["winner"] = 1;
        },
        "/winner must not be there before the game is over");
    expect_bad_state([](Json& state) { state["turn"] = 2; }, "/turn must be from 0 to 1");
    expect_bad_state([](Json& state) { state["part"]["in_hand"] = 1; },
                     "/part/in_hand must be true or false");
    Json tree = sample<TableChanged>();
    tree["table"]["state"]["part"]["type"] = "marbles";
    expect_refused(tree, RejectCode::kUnknownType,
                   "field /table/state/part/type is none that is known here");
}

/// What an End Game allows before its first shot, as a tree to spoil.
Json legal() {
    return {{"seat", 0},
            {"place", {{"low", {-0.4, -0.3}}, {"high", {-0.4, 0.3}}}},
            {"shoot",
             {{"min_speed", 1},
              {"max_speed", 3},
              {"own_speed", 2},
              {"max_offset", 0},
              {"max_elevation", 0}}},
            {"aim", {1, 0}}};
}

TEST(DecodeServer, RefusesBoundsBetweenWhichNothingLies) {
    const auto table_with = [](const Json& allowed) {
        Json tree = sample<TableChanged>();
        tree["table"]["legal"] = allowed;
        return tree;
    };
    ASSERT_TRUE(decode_server(table_with(legal()).dump(), Encoding::kJson).ok());
    const auto expect_bad_legal = [&](const char* pointer, const Json& value,
                                      const std::string& reason) {
        Json allowed = legal();
        allowed[Json::json_pointer(pointer)] = value;
        expect_bad(table_with(allowed), "field /table/legal" + reason);
    };
    expect_bad_legal("/place/high", {-0.4, -0.31}, "/place/high must not be below low");
    expect_bad_legal("/place/low", {-0.3, 0}, "/place/high must not be below low");
    expect_bad_legal("/shoot/max_speed", 0.5, "/shoot/max_speed must not be below min_speed");
    expect_bad_legal("/shoot/own_speed", 3.5,
                     "/shoot/own_speed must be from min_speed to max_speed");
    expect_bad_legal("/shoot/max_offset", 1.5, "/shoot/max_offset must be from 0.0 to 1.0");
    expect_bad_legal("/aim", {0, 0}, "/aim must not be zero");
}

TEST(DecodeServer, RefusesHashesThatAreNotSixteenHexDigits) {
    for (const char* hash : {"", "0123456789abcde", "0123456789abcdefa", "0123456789ABCDEF",
                             "0x23456789abcdef", "0123456789abcde "}) {
        Json tree = sample<ShotStarted>();
        tree["scene_hash"] = hash;
        expect_bad(tree, "field /scene_hash must be 16 lower-case hex digits");
    }
    Json tree = sample<ShotStarted>();
    tree["scene_hash"] = 5;
    expect_bad(tree, "field /scene_hash must be a string");
}

TEST(DecodeServer, RefusesEventsThatLackWhatTheirKindHasOrHaveMore) {
    ASSERT_TRUE(decode_server(frame_with(rail_event()).dump(), Encoding::kJson).ok());
    const auto expect_bad_event = [](const std::function<void(Json&)>& spoil,
                                     const std::string& reason) {
        Json event = rail_event();
        spoil(event);
        expect_bad(frame_with(event), "field /events/0" + reason);
    };
    expect_bad_event([](Json& e) { e["t"] = -1; },
                     "/t must be from 0.0 to 1.7976931348623157e+308");
    expect_bad_event(
        [](Json& e) { e["kind"] = "boom"; },
        "/kind must be one of strike, roll_to_rest, ball_ball, ball_rail, ball_pocket, "
        "slide_to_roll, spin_to_rest, bounce, off_table");
    expect_bad_event([](Json& e) { e["balls"] = {1024}; }, "/balls/0 must be from 0 to 1023");
    expect_bad_event(
        [](Json& e) {
            e["balls"] = {0, 1};
        },
        "/balls must have one index for each ball of its kind");
    expect_bad_event([](Json& e) { e["balls"] = {0, 1, 2}; }, "/balls must have 0 to 2 elements");
    expect_bad_event([](Json& e) { e["before"] = Json::array(); },
                     "/before must have one state for each ball");
    expect_bad_event([](Json& e) { e["after"].push_back(e["after"][0]); },
                     "/after must have one state for each ball");
    expect_bad_event([](Json& e) { e.erase("rail"); },
                     "/rail must be there for ball_rail and for nothing else");
    expect_bad_event([](Json& e) { e["pocket"] = "NE"; },
                     "/pocket must be there for ball_pocket and for nothing else");
    expect_bad_event(
        [](Json& e) {
            e["after"][0]["v"] = {1, 2};
        },
        "/after/0/v must have 3 elements");
}

TEST(DecodeServer, RefusesFramesOfBallsThatCannotBe) {
    Json tree{{"type", "frame"},
              {"shot", 1},
              {"tick", 1},
              {"balls", {{0, 1e9, 0}}},
              {"events", Json::array()}};
    expect_bad(tree, "field /balls/0/1 must be from -1000.0 to 1000.0");
    tree["balls"] = {{-1, 0, 0}};
    expect_bad(tree, "field /balls/0/0 must be from 0 to 1023");
    tree["balls"] = {{0, 0}};
    expect_bad(tree, "field /balls/0 must have 3 elements");
}

TEST(DecodeServer, RefusesAPocketedBallWithoutItsPocket) {
    Json tree = sample<ShotEnded>();
    const Json state{{"r", {0, 0, 0}}, {"v", {1, 0, 0}}, {"w", {0, 0, 0}}};
    Json ball{{"motion", "pocketed"}};
    ball.update(state);
    tree["balls"] = Json::array({ball});
    expect_bad(tree, "field /balls/0/pocket must be there for a pocketed ball and for no other");
}

TEST(DecodeServer, RefusesMessagesBeyondOneMebibyte) {
    const std::string bytes = R"({"type":"pong","seq":1})" + std::string(1U << 20U, ' ');
    EXPECT_FALSE(decode_server(bytes, Encoding::kJson).ok());
}

TEST(Names, OfCodesAreAllDifferent) {
    std::set<std::string_view> names;
    for (int i = 0; i <= static_cast<int>(RejectCode::kStorage); ++i)
        names.insert(name(static_cast<RejectCode>(i)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(RejectCode::kStorage) + 1);
    EXPECT_FALSE(names.contains(""));
}

}  // namespace
}  // namespace poolhall::protocol
