#include "protocol/text.hpp"

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace poolhall::protocol {
namespace {

TEST(JoinCodes, AreSpokenInTwoGroups) {
    EXPECT_EQ(spoken_code("BCDFGH"), "BCD-FGH");
    EXPECT_EQ(spoken_code("XY"), "XY");
    EXPECT_EQ(spoken_code(""), "");
}

TEST(Utf8, AcceptsEveryLength) {
    EXPECT_TRUE(is_utf8(""));
    EXPECT_TRUE(is_utf8("a\x7F"));
    EXPECT_TRUE(is_utf8("\xC2\x80 \xDF\xBF"));
    EXPECT_TRUE(is_utf8("\xE0\xA0\x80 \xED\x9F\xBF \xEE\x80\x80 \xEF\xBF\xBF"));
    EXPECT_TRUE(is_utf8("\xF0\x90\x80\x80 \xF4\x8F\xBF\xBF"));
}

TEST(Utf8, RefusesWhatIsIllFormed) {
    for (const char* text :
         {"\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xC2", "\xC2\x41", "\xE0\x9F\xBF", "\xE2\x82",
          "\xED\xA0\x80", "\xED\xBF\xBF", "\xF0\x8F\xBF\xBF", "\xF0\x9F\x98", "\xF4\x90\x80\x80",
          "\xF5\x80\x80\x80", "\xFF"}) {
        EXPECT_FALSE(is_utf8(text)) << ::testing::PrintToString(std::string(text));
        EXPECT_FALSE(is_utf8("ok" + std::string(text)));
    }
}

TEST(HexFloats, AreReadExactly) {
    EXPECT_EQ(parse_hex_float("0x1.8p-1"), 0.75);
    EXPECT_EQ(parse_hex_float("-0X1.8P+1"), -3.0);
    EXPECT_EQ(parse_hex_float("+0x.8p1"), 1.0);
    EXPECT_EQ(parse_hex_float("0x10"), 16.0);
    EXPECT_EQ(parse_hex_float("0x0p0"), 0.0);
    EXPECT_EQ(parse_hex_float("0x1.fffffffffffffp+1023"), std::numeric_limits<double>::max());
    EXPECT_EQ(parse_hex_float("0x0.0000000000001p-1022"),
              std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(parse_hex_float("0x1.d42c3c9eecbfbp-6"), 0.028575);
}

TEST(HexFloats, AgreeWithPrintf) {
    for (const double value : {0.1, 1.0 / 3, 6.02e23, -1e-300, 12345.678, 4.9e-324}) {
        char text[64];
        std::snprintf(text, sizeof text, "%a", value);
        EXPECT_EQ(parse_hex_float(text), value) << text;
    }
}

TEST(HexFloats, WithMoreBitsThanADoubleHasAreRefused) {
    for (const char* text : {"0x1.00000000000008p0", "0x1.fffffffffffff8p0", "0x20000000000001",
                             "0x1p-1075", "0x1.8p-1074", "-0x0.00000000000018p-1022"})
        EXPECT_EQ(parse_hex_float(text), std::nullopt) << text;
    for (const char* text : {"0x1.00000000000010p0", "0x1fffffffffffff00", "0x1p-1074",
                             "0x000001.8", "0x0.000000000000000000000000008P+4", "0x0p-99999"})
        EXPECT_TRUE(parse_hex_float(text)) << text;
}

TEST(HexFloats, InAnyOtherFormAreRefused) {
    for (const char* text : {"",          "0x",      "x1p0",
                             "1.5",       "0x1p",    "0x1p+",
                             "0x1.8p-1 ", " 0x1p0",  "0x1p0x",
                             "0x-1p0",    "--0x1p0", "0xinf",
                             "0xnan",     "inf",     "nan",
                             "0x1p1024",  "0x1,8p0", "0x1.8.8p0",
                             "0x.p0",     "0xp1",    "0x1p99999999999999999999"}) {
        EXPECT_EQ(parse_hex_float(text), std::nullopt) << text;
    }
}

TEST(ShownKeys, AreShortAndPrintable) {
    EXPECT_EQ(shown("seat"), "seat");
    EXPECT_EQ(shown("a\x1B[2Jb\xFF"), "a?[2Jb?");
    EXPECT_LT(shown(std::string(4000, 'x')).size(), 60U);
    std::string wide;
    for (int i = 0; i < 40; ++i)
        wide += "é";
    EXPECT_TRUE(is_utf8(shown(wide)));
}

}  // namespace
}  // namespace poolhall::protocol
