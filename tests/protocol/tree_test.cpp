#include "protocol/tree.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

namespace poolhall::protocol {
namespace {

using namespace std::string_literals;

std::string fault(const std::string& bytes, Encoding encoding) {
    const auto tree = parse_tree(bytes, encoding);
    return tree.ok() ? "none: " + tree->dump() : tree.error().reason;
}

std::string cbor_fault(const std::string& bytes) {
    return fault(bytes, Encoding::kCbor);
}

TEST(ParseTree, ReadsEachKindOfValue) {
    const auto expected = nlohmann::ordered_json::parse(
        R"({"a":null,"b":true,"c":[-1,0,23,24,256,70000,5000000000,-300],"d":1.5,"e":0.1,"f":"é"})");
    for (const Encoding encoding : {Encoding::kJson, Encoding::kCbor}) {
        const auto tree = parse_tree(write_tree(expected, encoding), encoding);
        ASSERT_TRUE(tree.ok()) << tree.error().reason;
        EXPECT_EQ(*tree, expected);
    }
}

TEST(ParseTree, ReadsHalfPrecisionFloats) {
    const auto tree = parse_tree("\xF9\x3E\x00"s, Encoding::kCbor);
    ASSERT_TRUE(tree.ok());
    EXPECT_EQ(tree->get<double>(), 1.5);
}

TEST(ParseTree, NumbersThatNeither64BitsNorADoubleHoldAreOfNoType) {
    for (const char* json : {"1e400", "-2E308", "18446744073709551617", "-9223372036854775809"}) {
        const auto tree = parse_tree(json, Encoding::kJson);
        ASSERT_TRUE(tree.ok()) << json;
        EXPECT_TRUE(tree->is_discarded()) << json;
    }
    for (const char* json : {"18446744073709551616", "-9223372036854775808", "1.7e308", "1e-400",
                             "0.1", "36893488147419103232"}) {
        const auto tree = parse_tree(json, Encoding::kJson);
        ASSERT_TRUE(tree.ok()) << json;
        EXPECT_TRUE(tree->is_number()) << json;
    }
}

TEST(ParseTree, ANumberBeyondAllDoublesHidesNoFaultBehindIt) {
    EXPECT_EQ(fault("[1e400,tru]", Encoding::kJson), "a syntax error at byte 11");
    EXPECT_EQ(fault("[1e400,1e400e]", Encoding::kJson), "a syntax error at byte 12");
    EXPECT_EQ(fault("[1e400", Encoding::kJson), "a syntax error at byte 7");
    EXPECT_EQ(fault(R"([1e400,{"a":1e400,"a":1}])", Encoding::kJson),
              "the key a twice in one object");
}

TEST(ParseTree, AllowsEightLevelsAndNotNine) {
    for (const Encoding encoding : {Encoding::kJson, Encoding::kCbor}) {
        nlohmann::ordered_json eight = 1;
        for (int i = 0; i < 8; ++i)
            eight = nlohmann::ordered_json::array({eight});
        EXPECT_TRUE(parse_tree(write_tree(eight, encoding), encoding).ok());
        const auto nine = write_tree(nlohmann::ordered_json::array({eight}), encoding);
        EXPECT_NE(fault(nine, encoding).find("nested too deeply"), std::string::npos);
    }
}

TEST(ParseTree, SurvivesDepthBombs) {
    constexpr std::size_t kBytes = 1 << 20;
    for (const char byte : {'\x81', '\xA1', '\x9F', '\xBF', '\x7F', '\x5F', '\xC0', '\xD8'})
        EXPECT_EQ(cbor_fault(std::string(kBytes, byte)).find("none"), std::string::npos);
    std::string maps;
    for (int i = 0; i < 100000; ++i)
        maps += "\xA1\x61k";
    EXPECT_EQ(cbor_fault(maps), "arrays or objects nested too deeply at byte 25");
    for (const char* text : {"[", "{\"a\":", "[["}) {
        std::string json;
        while (json.size() < kBytes)
            json += text;
        EXPECT_EQ(fault(json, Encoding::kJson), "arrays or objects nested too deeply");
    }
}

TEST(ParseTree, RefusesCborThatLiesAboutLengths) {
    EXPECT_EQ(cbor_fault("\x9B\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF"s),
              "a CBOR length beyond the message at byte 9");
    EXPECT_EQ(cbor_fault("\xBB\x80\0\0\0\0\0\0\0"s), "a CBOR length beyond the message at byte 9");
    EXPECT_EQ(cbor_fault("\x9A\x7F\xFF\xFF\xFF\x00"s),
              "a CBOR length beyond the message at byte 5");
    EXPECT_EQ(cbor_fault("\x7B\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF"s),
              "CBOR text longer than the message at byte 9");
    EXPECT_EQ(cbor_fault("\x65hi"), "CBOR text longer than the message at byte 1");
}

TEST(ParseTree, RefusesCborThatMessagesDoNotUse) {
    EXPECT_EQ(cbor_fault("\x42hi"), "a CBOR byte string at byte 1");
    EXPECT_EQ(cbor_fault("\xC1\x01"), "a CBOR tag at byte 1");
    EXPECT_EQ(cbor_fault("\x9F\x01\xFF"), "a CBOR item of indefinite length at byte 1");
    EXPECT_EQ(cbor_fault("\xFF"), "a CBOR item of indefinite length at byte 1");
    EXPECT_EQ(cbor_fault("\xF7"), "a CBOR simple value other than false, true and null at byte 1");
    EXPECT_EQ(cbor_fault("\xF8\x20"),
              "a CBOR simple value other than false, true and null at byte 2");
    EXPECT_EQ(cbor_fault("\x1C"), "a reserved CBOR item at byte 1");
    EXPECT_EQ(cbor_fault("\xA1\x01\x02"), "a map key that is not text at byte 1");
    EXPECT_EQ(cbor_fault("\x01\x02"), "bytes after the end of the message at byte 1");
    EXPECT_EQ(cbor_fault(""), "the CBOR ends too soon at byte 0");
    EXPECT_EQ(cbor_fault("\x19\x01"), "the CBOR ends too soon at byte 1");
}

TEST(ParseTree, RefusesTextThatIsNotUtf8) {
    EXPECT_EQ(cbor_fault("\x62\xC0\x80"), "text that is not UTF-8");
    EXPECT_EQ(cbor_fault("\xA1\x61\xFF\x01"), "a key that is not UTF-8");
    EXPECT_EQ(fault("\"\xED\xA0\x80\"", Encoding::kJson), "a syntax error at byte 3");
}

TEST(ParseTree, RefusesAKeyTwice) {
    EXPECT_EQ(fault(R"({"a":{"k":1,"k":2}})", Encoding::kJson), "the key k twice in one object");
    EXPECT_EQ(cbor_fault("\xA2\x61k\x01\x61k\x02"), "the key k twice in one object");
}

TEST(ParseTree, RefusesObjectsOfMoreThan64Keys) {
    std::string json = "{";
    for (int i = 0; i < 100; ++i)
        json += "\"" + std::to_string(i) + "\":1,";
    EXPECT_EQ(fault(json, Encoding::kJson), "too many keys in one object");
}

}  // namespace
}  // namespace poolhall::protocol
