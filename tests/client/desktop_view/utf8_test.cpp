#include "client/desktop/render/utf8.hpp"

#include <gtest/gtest.h>
#include <string>

namespace poolhall::client {
namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD";

TEST(LegibleTest, WellFormedTextIsKept) {
    const std::string text = "Zo\xC3\xAB \xE6\x97\xA5 \xF0\x9F\x8E\xB1";
    EXPECT_EQ(legible(text), text);
}

TEST(LegibleTest, IllFormedBytesAreReplaced) {
    EXPECT_EQ(legible("a\xFF"), std::string("a") + kReplacement);
    EXPECT_EQ(legible("\xC3"), kReplacement);                                  // cut short
    EXPECT_EQ(legible("\xC0\xAF"), std::string(kReplacement) + kReplacement);  // overlong
    EXPECT_EQ(legible("\xED\xA0\x80").substr(0, 3), kReplacement);             // surrogate
    EXPECT_EQ(legible("\xF4\x90\x80\x80").substr(0, 3), kReplacement);         // beyond U+10FFFF
}

TEST(LegibleTest, ControlCharactersBecomeSpaces) {
    EXPECT_EQ(legible(std::string_view("a\0b\nc\x7F\xC2\x85", 8)), "a b c  ");
}

TEST(LegibleTest, EndlessTextIsCut) {
    EXPECT_EQ(legible(std::string(100000, 'x')).size(), 512U);
}

TEST(FirstCharactersTest, CutsBetweenCharacters) {
    const std::string text = "\xC3\xABx\xE6\x97\xA5";
    EXPECT_EQ(first_characters(text, 0), "");
    EXPECT_EQ(first_characters(text, 1), "\xC3\xAB");
    EXPECT_EQ(first_characters(text, 2), "\xC3\xABx");
    EXPECT_EQ(first_characters(text, 9), text);
}

}  // namespace
}  // namespace poolhall::client
