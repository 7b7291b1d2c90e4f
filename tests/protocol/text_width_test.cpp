#include "protocol/intake/text_width.hpp"

#include <gtest/gtest.h>

namespace poolhall::protocol {
namespace {

TEST(TextWidth, CountsPlacesOnATerminal) {
    EXPECT_EQ(text_width(""), 0U);
    EXPECT_EQ(text_width("3 \xC2\xB5s"), 4U);
    EXPECT_EQ(text_width("\xE6\x9D\x8E\xE5\xB0\x8F\xE9\xBE\x99"), 6U) << "three wide characters";
    EXPECT_EQ(text_width("e\xCC\x81"), 1U) << "an accent of its own";
}

TEST(TextWidth, TakesWhatIsNoUtf8ByteByByte) {
    EXPECT_EQ(text_width("a\xFF\xC3"), 3U);
}

}  // namespace
}  // namespace poolhall::protocol
