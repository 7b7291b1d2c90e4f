#include "protocol/intake/person_name.hpp"

#include "protocol/text.hpp"

#include <gtest/gtest.h>
#include <random>
#include <string>

namespace poolhall::protocol {
namespace {

/// The name as it is kept, or "refused: " and why.
std::string kept(const std::string& entered) {
    const auto name = person_name(entered);
    return name ? *name : "refused: " + std::string(name.error().reason);
}

const std::string kEmpty = "refused: must not be empty";

TEST(PersonName, OfEveryScriptIsKeptAsItIs) {
    for (const char* name : {"Ann", "Renée", "Ζωή", "Анна", "عائشة", "דוד", "अनु", "安娜", "あんな",
                             "한나", "ไหม", "Ann-Marie O'Neill 2", "🎱", "😀 Bob", "+1"})
        EXPECT_EQ(kept(name), name);
}

TEST(PersonName, WithNothingVisibleIsRefused) {
    for (const char* name :
         {"",       " ",      "\t\n",       "\u00A0",     "\u2003\u3000", "\u200B",
          "\u200D", "\u00AD", "\u034F",     "\u115F",     "\u1160",       "\u17B4",
          "\u180E", "\u2060", "\u2800",     "\u3164",     "\uFE0F",       "\uFEFF",
          "\uFFA0", "\u0600", "\U0001D159", "\U000E0041", "\U000E0100",   " \u00AD \u3164 "})
        EXPECT_EQ(kept(name), kEmpty) << testing::PrintToString(std::string(name));
}

TEST(PersonName, IsTheSameWithBlanksAroundIt) {
    for (const char* blank : {" ", "   ", "\t", "\r\n", "\u0085", "\u00A0", "\u1680", "\u2007",
                              "\u2028", "\u202F", "\u205F", "\u3000", "\u2800"}) {
        EXPECT_EQ(kept(std::string("Ann") + blank), "Ann");
        EXPECT_EQ(kept(std::string(blank) + "Ann"), "Ann");
    }
}

TEST(PersonName, HasOneSpaceForEachRunOfBlanks) {
    EXPECT_EQ(kept("Ann  \u3000 \u00A0Lee"), "Ann Lee");
    EXPECT_EQ(kept("Ann \u200B Lee"), "Ann Lee");
}

TEST(PersonName, IsTheSameWithCharactersThatADisplayIgnores) {
    for (const char* ignored : {"\u00AD", "\u200B", "\u200D", "\u2060", "\u3164", "\uFE0F",
                                "\U000E0041", "\U000E0100", "\u200E", "\u061C"}) {
        EXPECT_EQ(kept(std::string("Ann") + ignored), "Ann");
        EXPECT_EQ(kept(std::string("A") + ignored + "nn"), "Ann");
        EXPECT_EQ(kept(ignored + std::string("Ann") + ignored + " "), "Ann");
    }
}

TEST(PersonName, KeepsJoinersThatShapeTheLettersBesideThem) {
    for (const char* name : {"می\u200Cخواهم", "क्\u200Dष", "क्\u200Cष"})
        EXPECT_EQ(kept(name), name);
    EXPECT_EQ(kept("क्\u200D"), "क्");
    EXPECT_EQ(kept("می\u200C "), "می");
}

TEST(PersonName, IsComposed) {
    EXPECT_EQ(kept("Rene\u0301e"), "Renée");
    EXPECT_EQ(kept("\u1112\u1161\u11AB"), "한");
    EXPECT_EQ(kept("A\u030A"), kept("\u212B"));
}

TEST(PersonName, WithACombiningMarkOnNothingIsRefused) {
    const std::string alone =
        "refused: must not have a combining mark without a character before it";
    for (const char* name : {"\u0301", " \u0301", "\u0301Ann", "Ann \u0301", "\u20DD", "\u0903"})
        EXPECT_EQ(kept(name), alone) << testing::PrintToString(std::string(name));
}

TEST(PersonName, WithControlCharactersIsRefused) {
    for (const char* name : {"a\nb", "a\tb", "a\x7F", "a\u0080z", "a\u2028b", "a\u202Eb",
                             "a\u2066b", "a\x1B[2J", "\u202Eb"})
        EXPECT_EQ(kept(name), "refused: must not have control characters");
    EXPECT_EQ(kept(std::string("a\0b", 3)), "refused: must not have control characters");
}

TEST(PersonName, OfWhatUnicodeHasNotAssignedIsRefused) {
    for (const char* name : {"\uE000", "Ann\uF8FF", "\U0010FFFD", "Ann\u0378", "\uFFFF", "\uFDD0",
                             "\U000E0000", "Ann\U000E0FFF"})
        EXPECT_EQ(kept(name),
                  "refused: must not have characters that are unassigned or for private use");
}

TEST(PersonName, IsBoundedBeforeAndAfterItIsComposed) {
    const std::string tooLong = "refused: must be at most 32 bytes of UTF-8";
    EXPECT_EQ(kept(std::string(32, 'x')), std::string(32, 'x'));
    EXPECT_EQ(kept(std::string(33, 'x')), tooLong);
    EXPECT_EQ(kept(std::string(32, 'x') + " "), tooLong);
    std::string grows;  // three bytes that NFC makes six
    for (int i = 0; i < 10; ++i)
        grows += "\u0958";
    EXPECT_EQ(kept(grows), tooLong);
}

TEST(PersonName, ThatIsNoUtf8IsRefused) {
    for (const char* name : {"\xFF", "a\xC0\x80", "\xED\xA0\x80", "\xE2\x82"})
        EXPECT_EQ(kept(name), "refused: must be UTF-8");
}

TEST(PersonName, ThatIsKeptIsKeptAsItIsTheNextTime) {
    std::mt19937 random(8);
    const std::string pool[] = {"a",      " ",      "\u0301", "\u00AD",    "\u200D", "\u200C",
                                "\u3164", "क",      "्",       "م",         "\u0327", "\u1112",
                                "\u1161", "\u00A0", "\u2800", "\U0001F3B1"};
    std::uniform_int_distribution<std::size_t> any(0, std::size(pool) - 1);
    int good = 0;
    for (int round = 0; round < 20000; ++round) {
        std::string entered;
        for (int i = 0; i < 8; ++i)
            entered += pool[any(random)];
        const auto name = person_name(entered);
        if (!name) continue;
        ++good;
        EXPECT_EQ(kept(*name), *name);
        EXPECT_FALSE(find_name_fault(*name)) << "those who read it would refuse it";
    }
    EXPECT_GT(good, 1000);
}

}  // namespace
}  // namespace poolhall::protocol
