#include "protocol/replay/line.hpp"

#include <gtest/gtest.h>

namespace poolhall::protocol {
namespace {

// The worked examples of REPLAY_FORMAT.md.
TEST(Checksum, IsFnv1aOf64Bits) {
    EXPECT_EQ(checksum_text(""), "cbf29ce484222325");
    EXPECT_EQ(checksum_text("a"), "af63dc4c8601ec8c");
    EXPECT_EQ(checksum_text("foobar"), "85944171f73967e8");
}

TEST(Checksum, OfTheDocumentedLineIsTheDocumentedOne) {
    const std::string_view record = R"({"n":2,"kind":"seat","seat":0,"name":"Ann"})";
    EXPECT_EQ(to_line({checksum_text(record), record}),
              R"({"sum":"ea4c5e5bf30d98c5","record":{"n":2,"kind":"seat","seat":0,"name":"Ann"}})"
              "\n");
}

TEST(Line, ComesApartAsItWasPutTogether) {
    const std::string line = to_line({"0123456789abcdef", R"({"n":1})"});
    const auto parts = split_line(std::string_view(line).substr(0, line.size() - 1));
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->sum, "0123456789abcdef");
    EXPECT_EQ(parts->record, R"({"n":1})");
}

TEST(Line, AnyOtherFormIsRefused) {
    for (const std::string_view line :
         {R"()", R"({})", R"({"sum":"0123456789abcdef","record":})",
          R"({"sum":"0123456789ABCDEF","record":{}})", R"({"sum":"0123456789abcdef","record":{} )",
          R"({"sum":"0123456789abcdef", "record":{}})", R"({"record":{},"sum":"0123456789abcdef"})",
          "{\"sum\":\"0123456789abcdef\",\"record\":{}}\r"}) {
        EXPECT_FALSE(split_line(line)) << line;
    }
}

}  // namespace
}  // namespace poolhall::protocol
