#include "client/play/isolated.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

TEST(Isolated, NameInAsciiStaysAsItIs) {
    EXPECT_EQ(isolated("Anna 2!"), "Anna 2!");
    EXPECT_EQ(isolated(""), "");
}

TEST(Isolated, AnyOtherNameStandsBetweenIsolates) {
    EXPECT_EQ(isolated("שרה!"), "\u2068שרה!\u2069");
    EXPECT_EQ(isolated("Zoë"), "\u2068Zoë\u2069");
}

TEST(Isolated, MarksOfDirectionInsideItAreLeftOut) {
    EXPECT_EQ(isolated("a\u202Eb\u2069c\u2066"), "\u2068abc\u2069");
    EXPECT_EQ(isolated("é\u202A\u202C\u2067…"), "\u2068é…\u2069") << "U+2026 is none";
}

TEST(Isolated, BytesCutShortAreKept) {
    EXPECT_EQ(isolated("x\xE2\x80"), "\u2068x\xE2\x80\u2069");
}

}  // namespace
}  // namespace poolhall::client
