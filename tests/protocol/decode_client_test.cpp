#include "protocol/intake/decode_client.hpp"

#include "protocol/codec/codec.hpp"
#include "tests/protocol/refusals.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace poolhall::protocol {
namespace {

using testing::expect_refused;

TEST(DecodeClient, ReadsAMessageWrittenByHand) {
    const auto result = decode_client(
        R"( {"move": {"strike": {"direction": [1, -0.5e1]}, "type": "shoot"}, "seat": 1,
             "type": "move", "seq": 12} )",
        Encoding::kJson);
    ASSERT_TRUE(result.ok()) << result.error().reason;
    const MakeMove expected{Seat{1}, Shoot{Stroke{{1, -5}, {}, {}, 0}}};
    EXPECT_EQ(*result, (ClientMessage{12, TurnCommand{expected}}));
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
            << ::testing::PrintToString(integer);
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
                [](const auto& entry) {
                    if constexpr (requires { entry.name; }) return entry.name;
                    return std::string();
                },
                std::get<EntryCommand>(result->body));
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
