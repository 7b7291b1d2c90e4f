#include "protocol/codec/codec.hpp"
#include "tests/protocol/refusals.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace poolhall::protocol {
namespace {

using testing::expect_refused;

/// A `move` command with this move, in JSON.
std::string with_move(const std::string& move) {
    return R"({"type":"move","seq":1,"seat":0,"move":)" + move + "}";
}

/// A shot with these fields of its strike.
std::string with_strike(const std::string& fields) {
    return with_move(R"({"type":"shoot","strike":{)" + fields + "}}");
}

/// The move of a message that must be good.
Move move_in(const std::string& json) {
    const auto result = decode_client(json, Encoding::kJson);
    EXPECT_TRUE(result.ok()) << json << "\n" << (result.ok() ? "" : result.error().reason);
    if (!result.ok()) return {};
    return std::get<MakeMove>(std::get<TurnCommand>(result->body)).move;
}

TEST(DecodeMove, ReadsEveryMoveWithEveryField) {
    EXPECT_EQ(move_in(with_strike(
                  R"("direction":[1,0.5],"speed":3,"offset":[-0.25,0.5],"elevation":0.125)")),
              (Move{Shoot{Stroke{{1, 0.5}, 3.0, {-0.25, 0.5}, 0.125}}}));
    EXPECT_EQ(move_in(with_move(R"({"type":"place","position":[-0.5,0.25]})")),
              (Move{Place{{-0.5, 0.25}}}));
    EXPECT_EQ(move_in(with_move(R"({"type":"concede"})")), Move{Concede{}});
    EXPECT_EQ(move_in(with_move(R"({"type":"agree","what":"rematch"})")),
              (Move{Agree{Accord::kRematch}}));
    EXPECT_EQ(move_in(with_move(R"({"type":"time_out"})")), Move{TimeOut{}});
}

TEST(DecodeMove, LeavesToTheGameWhatAStrikeLeavesOut) {
    const Move move = move_in(with_strike(R"("direction":[1,0])"));
    const Stroke& strike = std::get<Shoot>(move).strike;
    EXPECT_EQ(strike.speed, std::nullopt);
    EXPECT_EQ(strike.offset, (Vec2{0, 0}));
    EXPECT_EQ(strike.elevation, 0);
}

TEST(DecodeMove, RefusesMovesOfNoKindByTheirType) {
    const auto refused = [](const std::string& move, RejectCode code, const std::string& reason) {
        expect_refused(with_move(move), code, reason);
    };
    refused(R"({"type":"dance"})", RejectCode::kUnknownType,
            "field /move/type is none that is known here");
    refused(R"({"type":"ping"})", RejectCode::kUnknownType, "field /move/type");
    refused(R"({"what":"rematch"})", RejectCode::kMissingField, "field /move/type is missing");
    refused(R"({"type":7})", RejectCode::kBadField, "field /move/type must be a string");
    for (const char* no_object : {"null", "[]", "\"shoot\"", "1", "true"})
        refused(no_object, RejectCode::kBadField, "field /move must be an object");
    expect_refused(R"({"type":"move","seq":1,"seat":0})", RejectCode::kMissingField,
                   "field /move is missing");
    expect_refused(R"({"type":"move","seq":1,"move":{"type":"concede"}})",
                   RejectCode::kMissingField, "field /seat is missing");
}

TEST(DecodeMove, RefusesMovesWithoutTheirFieldsOrWithOthers) {
    const auto refused = [](const std::string& move, RejectCode code, const std::string& pointer) {
        expect_refused(with_move(move), code, "field /move" + pointer);
    };
    refused(R"({"type":"shoot"})", RejectCode::kMissingField, "/strike is missing");
    refused(R"({"type":"shoot","strike":{}})", RejectCode::kMissingField,
            "/strike/direction is missing");
    refused(R"({"type":"shoot","strike":[1,0]})", RejectCode::kBadField,
            "/strike must be an object");
    refused(R"({"type":"place"})", RejectCode::kMissingField, "/position is missing");
    refused(R"({"type":"agree"})", RejectCode::kMissingField, "/what is missing");
    refused(R"({"type":"agree","what":"draw"})", RejectCode::kBadField,
            "/what must be one of rematch");
    refused(R"({"type":"concede","seat":0})", RejectCode::kUnknownField, "/seat");
    refused(R"({"type":"time_out","seq":1})", RejectCode::kUnknownField, "/seq");
    refused(R"({"type":"place","position":[0,0],"direction":[1,0]})", RejectCode::kUnknownField,
            "/direction");
    refused(R"({"type":"shoot","strike":{"direction":[1,0],"spin":1}})", RejectCode::kUnknownField,
            "/strike/spin");
    refused(R"({"type":"shoot","strike":{"direction":[1,0]},"call":"safety"})",
            RejectCode::kUnknownField, "/call");
}

TEST(DecodeMove, RefusesStrikesOutOfRange) {
    const auto refused = [](const std::string& field, const std::string& reason) {
        expect_refused(with_strike(R"("direction":[1,0],)" + field), RejectCode::kBadField,
                       "field /move/strike" + reason);
    };
    refused(R"("speed":-0.5)", "/speed must be from 0.0 to ");
    refused(R"("speed":"6")", "/speed must be a number");
    refused(R"("speed":null)", "/speed must be a number");
    refused(R"("offset":[1.5,0])", "/offset/0 must be from -1.0 to 1.0");
    refused(R"("offset":[0,true])", "/offset/1 must be a number");
    refused(R"("offset":[0])", "/offset must have 2 elements");
    refused(R"("elevation":-1)", "/elevation must be from 0.0 to ");
    refused(R"("elevation":[0])", "/elevation must be a number");
}

TEST(DecodeMove, RefusesDirections) {
    const auto refused = [](const std::string& direction, const std::string& reason) {
        const std::string field = R"("direction":)" + direction;
        expect_refused(R"({"seq":1,"seat":0,"type":"aim",)" + field + "}", RejectCode::kBadField,
                       "field /direction" + reason);
        expect_refused(with_strike(field), RejectCode::kBadField,
                       "field /move/strike/direction" + reason);
    };
    refused("[0,0]", " must not be zero");
    refused("[0,-0.0]", " must not be zero");
    refused("[1]", " must have 2 elements");
    refused("[1,0,0]", " must have 2 elements");
    refused("[1,\"0x1p0\"]", "/1 must be a number");
    refused("[null,1]", "/0 must be a number");
    refused("[1,1000001]", "/1");
    refused("[-1e300,0]", "/0");
    refused("{\"x\":1,\"y\":0}", " must be an array");
}

TEST(DecodeMove, RefusesPositions) {
    const auto refused = [](const std::string& position, const std::string& reason) {
        expect_refused(with_move(R"({"type":"place","position":)" + position + "}"),
                       RejectCode::kBadField, "field /move/position" + reason);
        expect_refused(
            R"({"type":"aim","seq":1,"seat":0,"direction":[1,0],"cue":)" + position + "}",
            RejectCode::kBadField, "field /cue" + reason);
    };
    refused("[1000.5,0]", "/0 must be from -1000.0 to 1000.0");
    refused("[0,\"1\"]", "/1 must be a number");
    refused("[0,0,0]", " must have 2 elements");
    refused("0", " must be an array");
    refused("null", " must be an array");
}

/// The message in CBOR, where numbers may be what JSON has no words for.
Result<ClientMessage, DecodeError> decode_as_cbor(const nlohmann::json& tree) {
    std::string cbor;
    nlohmann::json::to_cbor(tree, cbor);
    return decode_client(cbor, Encoding::kCbor);
}

TEST(DecodeMove, RefusesNumbersThatAreNotFinite) {
    const nlohmann::json whole_strike{
        {"direction", {1.0, 0.0}}, {"speed", 1.0}, {"offset", {0.0, 0.0}}, {"elevation", 0.0}};
    const nlohmann::json shot{{"type", "move"},
                              {"seq", 1},
                              {"seat", 0},
                              {"move", {{"type", "shoot"}, {"strike", whole_strike}}}};
    const nlohmann::json place{{"type", "move"},
                               {"seq", 1},
                               {"seat", 0},
                               {"move", {{"type", "place"}, {"position", {0.0, 0.0}}}}};
    ASSERT_TRUE(decode_as_cbor(shot).ok());
    ASSERT_TRUE(decode_as_cbor(place).ok());
    const auto expect_refused_at = [](nlohmann::json tree, const std::string& pointer, double bad) {
        tree[nlohmann::json::json_pointer(pointer)] = bad;
        const auto result = decode_as_cbor(tree);
        ASSERT_FALSE(result.ok()) << pointer;
        EXPECT_EQ(result.error().code, RejectCode::kBadField);
        EXPECT_EQ(result.error().reason, "field " + pointer + " must be finite");
    };
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double bad : {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
        for (const char* field :
             {"/direction/0", "/direction/1", "/speed", "/offset/0", "/offset/1", "/elevation"})
            expect_refused_at(shot, std::string("/move/strike") + field, bad);
        expect_refused_at(place, "/move/position/0", bad);
        expect_refused_at(place, "/move/position/1", bad);
    }
}

}  // namespace
}  // namespace poolhall::protocol
