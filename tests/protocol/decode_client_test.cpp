#include "protocol/intake/decode_client.hpp"

#include "protocol/codec/codec.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace poolhall::protocol {
namespace {

/// Expects a refusal for a reason, in JSON and, where JSON can be put into CBOR, there too.
void expect_refused(const std::string& json, RejectCode code, const std::string& in_reason) {
    const auto result = decode_client(json, Encoding::kJson);
    ASSERT_FALSE(result.ok()) << json;
    EXPECT_EQ(name(result.error().code), name(code)) << json << "\n" << result.error().reason;
    EXPECT_NE(result.error().reason.find(in_reason), std::string::npos) << result.error().reason;

    const auto tree = nlohmann::json::parse(json, nullptr, false);
    if (tree.is_discarded() || code == RejectCode::kMalformed) return;
    std::string cbor;
    nlohmann::json::to_cbor(tree, cbor);
    const auto binary = decode_client(cbor, Encoding::kCbor);
    ASSERT_FALSE(binary.ok()) << json;
    EXPECT_EQ(binary.error().code, code) << json;
}

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

TEST(DecodeClient, ReadsAMessageWrittenByHand) {
    const auto result = decode_client(
        R"( {"move": {"strike": {"direction": [1, -0.5e1]}, "type": "shoot"}, "seat": 1,
             "type": "move", "seq": 12} )",
        Encoding::kJson);
    ASSERT_TRUE(result.ok()) << result.error().reason;
    const MakeMove expected{Seat{1}, Shoot{Stroke{{1, -5}, {}, {}, 0}}};
    EXPECT_EQ(*result, (ClientMessage{12, TurnCommand{expected}}));
}

TEST(DecodeClient, ReadsEveryMoveWithEveryField) {
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

TEST(DecodeClient, LeavesToTheGameWhatAStrikeLeavesOut) {
    const Move move = move_in(with_strike(R"("direction":[1,0])"));
    const Stroke& strike = std::get<Shoot>(move).strike;
    EXPECT_EQ(strike.speed, std::nullopt);
    EXPECT_EQ(strike.offset, (Vec2{0, 0}));
    EXPECT_EQ(strike.elevation, 0);
}

TEST(DecodeClient, RefusesMovesOfNoKindByTheirType) {
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

TEST(DecodeClient, RefusesMovesWithoutTheirFieldsOrWithOthers) {
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

TEST(DecodeClient, RefusesStrikesOutOfRange) {
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

TEST(DecodeClient, FillsInDefaults) {
    const auto result =
        decode_client(R"({"type":"create_match","seq":1,"name":"Ann"})", Encoding::kJson);
    ASSERT_TRUE(result.ok()) << result.error().reason;
    EXPECT_EQ(*result,
              (ClientMessage{1, EntryCommand{CreateMatch{"Ann", "end_game", Stream::kStates}}}));
}

TEST(DecodeClient, TakesCodesAsPeopleTypeThem) {
    for (const char* typed : {"BCDFGH", "bcdfgh", "bcd-fgh", "BCD FGH", " b c d f g h "}) {
        const std::string json =
            std::string(R"({"type":"watch_match","seq":1,"name":"","code":")") + typed + R"("})";
        const auto result = decode_client(json, Encoding::kJson);
        ASSERT_TRUE(result.ok()) << typed << ": " << result.error().reason;
        EXPECT_EQ(std::get<WatchMatch>(std::get<EntryCommand>(result->body)).code, "BCDFGH");
    }
}

TEST(DecodeClient, RefusesWhatIsNoObject) {
    for (const char* bytes :
         {"", " ", "{", "nonsense", "[]", "1", "null", "\"ping\"",
          "{\"type\":\"ping\",\"seq\":1}{}", "{'type':'ping'}", "{\"type\":\"ping\",\"seq\":1,}",
          "{\"seq\":NaN}", "{\"type\":\"\xC0\x80\"}", "{\"type\":\"\xFF\"}"}) {
        expect_refused(bytes, RejectCode::kMalformed, "the message");
    }
}

TEST(DecodeClient, RefusesTheSameKeyTwice) {
    expect_refused(R"({"type":"ping","seq":1,"seq":2})", RejectCode::kMalformed, "seq twice");
}

TEST(DecodeClient, RefusesNestingBeyondEightLevels) {
    const std::string bomb(2000, '[');
    expect_refused(R"({"type":"ping","seq":)" + bomb, RejectCode::kMalformed, "nested too deeply");
    expect_refused(bomb, RejectCode::kMalformed, "nested too deeply");
}

TEST(DecodeClient, RefusesMessagesBeyond4096Bytes) {
    expect_refused(R"({"type":"ping","seq":1})" + std::string(4096, ' '), RejectCode::kMalformed,
                   "longer than 4096 bytes");
}

TEST(DecodeClient, RefusesMessagesOfNoKnownType) {
    expect_refused(R"({"seq":1})", RejectCode::kMissingField, "/type");
    expect_refused(R"({"type":"fly","seq":1})", RejectCode::kUnknownType, "/type");
    expect_refused(R"({"type":"welcome","seq":1})", RejectCode::kUnknownType, "/type");
    expect_refused(R"({"type":"shoot","seq":1})", RejectCode::kUnknownType, "field /type");
    expect_refused(R"({"type":5,"seq":1})", RejectCode::kBadField, "/type");
}

TEST(DecodeClient, RefusesSequenceNumbersThatAreNotFrom1To2To32) {
    expect_refused(R"({"type":"ping"})", RejectCode::kMissingField, "/seq");
    for (const char* seq : {"0", "-1", "4294967296", "1.0", "1.5", "\"1\"", "null", "true", "[1]",
                            "18446744073709551616", "18446744073709551617", "-0",
                            "-9223372036854775809", "1e999", "-1e999", "1e400"}) {
        expect_refused(std::string(R"({"type":"ping","seq":)") + seq + "}", RejectCode::kBadField,
                       "/seq");
    }
}

TEST(DecodeClient, NamesTheSequenceNumberOfWhatItRefuses) {
    const auto result = decode_client(R"({"type":"take_seat","seq":41})", Encoding::kJson);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().seq, 41U);
    EXPECT_EQ(result.error().reason, "field /seat is missing");
}

TEST(DecodeClient, RefusesMissingFields) {
    expect_refused(R"({"type":"create_match","seq":1})", RejectCode::kMissingField, "/name");
    expect_refused(R"({"type":"aim","seq":1,"seat":0})", RejectCode::kMissingField, "/direction");
}

TEST(DecodeClient, RefusesUnknownFields) {
    expect_refused(R"({"type":"ping","seq":1,"extra":0})", RejectCode::kUnknownField, "/extra");
    expect_refused(R"({"type":"ping","seq":1,"a/b~c":0})", RejectCode::kUnknownField, "/a~1b~0c");
    expect_refused(R"({"type":"leave","seq":1,"\u001b[2J":0})", RejectCode::kUnknownField, "/?[2J");
}

TEST(DecodeClient, RefusesSeatsOtherThan0And1) {
    for (const char* seat : {"2", "-1", "1e0", "256", "\"0\"", "null"}) {
        expect_refused(std::string(R"({"type":"take_seat","seq":1,"seat":)") + seat + "}",
                       RejectCode::kBadField, "/seat");
    }
}

TEST(DecodeClient, RefusesDirections) {
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

TEST(DecodeClient, RefusesPositions) {
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

TEST(DecodeClient, RefusesNumbersThatAreNotFinite) {
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

/// An aim in CBOR, its direction [NUMBER, 0], and seq after it.
std::string cbor_aim(const std::string& number) {
    using namespace std::string_literals;
    return "\xA4\x64type\x63"s
           "aim\x64seat\x00\x69"s
           "direction\x82"s +
           number + "\x00\x63seq\x18\x2A"s;
}

TEST(DecodeClient, RefusesNumbersThatTheFieldCannotHoldAndNamesTheirField) {
    using namespace std::string_literals;
    const auto refusal = [](const std::string& bytes, Encoding encoding) {
        const auto result = decode_client(bytes, encoding);
        if (result.ok()) return "taken"s;
        EXPECT_EQ(result.error().seq, 42U) << result.error().reason;
        return std::string(name(result.error().code)) + ": " + result.error().reason;
    };
    const std::string no_double =
        "bad_field: field /direction/0 must be a number that a double can hold";
    for (const std::string& integer :
         {"\x3B\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFA"s, "\x3B\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFE"s,
          "\x3B\x80\0\0\0\0\0\0\0"s, "\x3B\x80\0\0\0\0\0\0\x2A"s,
          "\x3B\x7F\xFF\xFF\xFF\xFF\xFF\xFF\xFE"s, "\x1B\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF"s,
          "\x1B\x00\x20\0\0\0\0\0\x01"s})
        EXPECT_EQ(refusal(cbor_aim(integer), Encoding::kCbor), no_double)
            << testing::PrintToString(integer);
    for (const std::string& integer :
         {"\x3B\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF"s, "\x3B\x7F\xFF\xFF\xFF\xFF\xFF\xFF\xFF"s,
          "\x1B\x80\0\0\0\0\0\0\0"s})
        EXPECT_EQ(refusal(cbor_aim(integer), Encoding::kCbor).substr(0, 47),
                  "bad_field: field /direction/0 must be from -100");
    for (const char* number : {"1e400", "-1e400", "1e309", "2e308", "9007199254740993",
                               "-9007199254740993", "18446744073709551615", "18446744073709551617",
                               "-18446744073709551611", "123456789012345678901234567890"}) {
        EXPECT_EQ(refusal(R"({"type":"aim","seat":0,"direction":[)" + std::string(number) +
                              R"(,0],"seq":42})",
                          Encoding::kJson),
                  no_double)
            << number;
    }
}

TEST(DecodeClient, NamesTheSequenceNumberThatFollowsANumberBeyondAllDoubles) {
    const auto result = decode_client(
        R"({"type":"join_match","name":"null 1e400 \"n","code":null,"x":[1e400,null,1e400],"seq":7})",
        Encoding::kJson);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().seq, 7U);
    EXPECT_EQ(result.error().reason.substr(0, 11), "field /code") << result.error().reason;
}

TEST(DecodeClient, TakesWholeNumbersThatADoubleHoldsInAnyForm) {
    for (const char* number : {"1", "1.0", "1e0", "10e-1", "-0", "1000000", "1e6", "0.1"}) {
        EXPECT_TRUE(decode_client(R"({"type":"aim","seq":1,"seat":-0,"direction":[)" +
                                      std::string(number) + ",1]}",
                                  Encoding::kJson)
                        .ok())
            << number;
    }
}

TEST(DecodeClient, RefusesNamesThatCannotBeShown) {
    const auto refused = [](const std::string& name, const std::string& why) {
        expect_refused(R"({"type":"create_match","seq":1,"name":)" + name + "}",
                       RejectCode::kBadField, "/name " + why);
    };
    refused("7", "must be a string");
    refused("\"\"", "must not be empty");
    refused("\"   \"", "must not be empty");
    refused("\"\\u200b\"", "must not be empty");
    refused('"' + std::string(33, 'x') + '"', "must be at most 32 bytes");
    refused("\"a\\u0000b\"", "must not have control characters");
    refused("\"a\\nb\"", "must not have control characters");
    refused("\"a\\u007f\"", "must not have control characters");
    refused("\"a\\u0085b\"", "must not have control characters");
    refused("\"a\\u202eb\"", "must not have control characters");
}

TEST(DecodeClient, RefusesGamesByLength) {
    expect_refused(R"({"type":"create_match","seq":1,"name":"A","game":""})", RejectCode::kBadField,
                   "/game");
    expect_refused(
        R"({"type":"create_match","seq":1,"name":"A","game":")" + std::string(33, 'x') + "\"}",
        RejectCode::kBadField, "/game");
}

TEST(DecodeClient, RefusesStreamsThatAreNotOffered) {
    expect_refused(R"({"type":"create_match","seq":1,"name":"A","stream":"all"})",
                   RejectCode::kBadField, "/stream must be one of states, shots");
    expect_refused(R"({"type":"create_match","seq":1,"name":"A","stream":null})",
                   RejectCode::kBadField, "/stream");
}

/// A create_match with these settings, in JSON.
std::string with_settings(const std::string& settings) {
    return R"({"type":"create_match","seq":1,"name":"A","settings":)" + settings + "}";
}

std::optional<MatchSettings> settings_in(const ClientMessage& message) {
    return std::get<CreateMatch>(std::get<EntryCommand>(message.body)).settings;
}

TEST(DecodeClient, ReadsHowAMatchIsPlayed) {
    const auto result = decode_client(
        with_settings(R"({"race_to":5,"breaks":"winner","shot_clock_s":30,"turns":"solo"})"),
        Encoding::kJson);
    ASSERT_TRUE(result.ok()) << result.error().reason;
    EXPECT_EQ(settings_in(*result), (MatchSettings{{}, 5, BreakOrder::kWinner, 30, Turns::kSolo}));
}

TEST(DecodeClient, TakesSettingsInTheFieldsOfAScene) {
    const auto result = decode_client(
        with_settings(
            R"({"effects":{"rolling":{},"sliding":{"mu":0.3}},"solver":{"kind":"event"}})"),
        Encoding::kJson);
    ASSERT_TRUE(result.ok()) << result.error().reason;
    MatchSettings expected;
    expected.game.effects.emplace().rolling = RollingSpec{0.01};
    expected.game.effects->sliding = SlidingSpec{0.3};
    expected.game.solver = SolverSpec{SolverKind::kEvent, 30};
    EXPECT_EQ(settings_in(*result), expected);
    for (const char* none : {"{}", R"({"effects":{}})"})
        EXPECT_TRUE(decode_client(with_settings(none), Encoding::kJson).ok()) << none;
}

TEST(DecodeClient, NamesTheSettingThatAMatchCannotHave) {
    const auto refused = [](const std::string& settings, const std::string& why,
                            RejectCode code = RejectCode::kBadField) {
        expect_refused(with_settings(settings), code, "/settings" + why);
    };
    for (const char* no_object : {"null", "[]", "7", "\"event\"", "true"})
        refused(no_object, " must be an object");
    refused(R"({"effects":[]})", "/effects must be an object");
    refused(R"({"effects":null})", "/effects must be an object");
    refused(R"({"effects":{"sliding":0.2}})", "/effects/sliding must be an object");
    refused(R"({"effects":{"sliding":{"mu":"0x1p-3"}}})", "/effects/sliding/mu must be a number");
    refused(R"({"effects":{"linear_drag":{"k":1}}})", "/effects/linear_drag/stop_speed",
            RejectCode::kMissingField);
    refused(R"({"effects":{"wind":{}}})", "/effects/wind", RejectCode::kUnknownField);
    refused(R"({"effects":{"rolling":{"mu":0.01,"nu":1}}})", "/effects/rolling/nu",
            RejectCode::kUnknownField);
    refused(R"({"effects":{"rail":{"model":"soft"}}})", "/effects/rail/model must be one of");
    refused(R"({"solver":{"kind":"verlet"}})", "/solver/kind must be one of");
    refused(R"({"solver":{}})", "/solver/kind", RejectCode::kMissingField);
    refused(R"({"solver":{"kind":"euler","hz":true}})", "/solver/hz must be a number");
    refused(R"({"race_to":-1})", "/race_to must be from 0 to 4294967295");
    refused(R"({"race_to":2.5})", "/race_to must be an integer");
    refused(R"({"breaks":"first"})", "/breaks must be one of alternate, winner, loser");
    refused(R"({"shot_clock_s":"30"})", "/shot_clock_s must be an integer");
    refused(R"({"shot_clock_s":null})", "/shot_clock_s must be an integer");
    refused(R"({"turns":"mine"})", "/turns must be one of shared, solo");
    refused(R"({"gravity":1.6})", "/gravity", RejectCode::kUnknownField);
    refused(R"({"table":{"length":9}})", "/table", RejectCode::kUnknownField);
}

TEST(DecodeClient, RefusesSettingsThatAreNotFinite) {
    for (const double bad :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        const nlohmann::json tree{{"type", "create_match"},
                                  {"seq", 1},
                                  {"name", "A"},
                                  {"settings", {{"effects", {{"rolling", {{"mu", bad}}}}}}}};
        std::string cbor;
        nlohmann::json::to_cbor(tree, cbor);
        const auto result = decode_client(cbor, Encoding::kCbor);
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.error().code, RejectCode::kBadField);
        EXPECT_EQ(result.error().reason, "field /settings/effects/rolling/mu must be finite");
    }
}

TEST(DecodeClient, KeepsNamesInOneForm) {
    for (const char* entered :
         {R"(Ren\u00e9e)", R"(Rene\u0301e)", R"( Ren\u00e9e\t)", R"(Ren\u00ad\u00e9e\u3164)"}) {
        for (const char* type : {"create_match", "join_match", "watch_match"}) {
            const bool creates = type == std::string("create_match");
            const std::string json = R"({"seq":1,"type":")" + std::string(type) + R"(","name":")" +
                                     entered + (creates ? R"("})" : R"(","code":"BCDFGH"})");
            const auto result = decode_client(json, Encoding::kJson);
            ASSERT_TRUE(result.ok()) << json << ": " << result.error().reason;
            const auto name = std::visit(
                [](const auto& body) {
                    if constexpr (requires { body.name; }) return body.name;
                    return std::string();
                },
                result->body);
            EXPECT_EQ(name, "Renée") << json;
        }
    }
}

TEST(DecodeClient, RefusesCodesThatAreNotSixOfTheLetters) {
    for (const char* code : {"", "BCDFG", "BCDFGHJ", "ABCDFG", "BCDFG1", "BCD_FGH", "ÖCDFGH",
                             "B-C-D-F-G-H------------------"}) {
        expect_refused(
            R"({"type":"join_match","seq":1,"name":"A","code":")" + std::string(code) + "\"}",
            RejectCode::kBadField, "/code");
    }
}

TEST(DecodeClient, RefusesTokensThatAreNot32LowerCaseHexDigits) {
    for (const std::string& token :
         {std::string(), std::string(31, '0'), std::string(33, '0'), std::string(32, 'A'),
          std::string(32, 'g'), std::string("../../../../../../../etc/passwd1")}) {
        expect_refused(R"({"type":"resume","seq":1,"code":"BCDFGH","token":")" + token + "\"}",
                       RejectCode::kBadField, "/token");
    }
}

}  // namespace
}  // namespace poolhall::protocol
