#include "server/base/log_text.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

TEST(LogText, NameCannotForgeALine) {
    EXPECT_EQ(in_quotes("Ada"), "\"Ada\"");
    EXPECT_EQ(in_quotes("a\nb\x1b[2J\"\\"), "\"a\\x0ab\\x1b[2J\\\"\\\\\"");
    EXPECT_EQ(in_quotes("\xe2\x80\xae"), "\"\\xe2\\x80\\xae\"");
}

}  // namespace
}  // namespace poolhall::server
