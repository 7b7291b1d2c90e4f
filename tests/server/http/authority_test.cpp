#include "server/http/authority.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

TEST(Authority, IsAHostWithOrWithoutAPort) {
    EXPECT_EQ(parse_authority("Pool.Example")->host, "pool.example");
    EXPECT_EQ(parse_authority("pool.example")->port, std::nullopt);
    EXPECT_EQ(parse_authority("pool.example:")->port, std::nullopt);
    EXPECT_EQ(parse_authority("pool.example:8080")->port, 8080);
    EXPECT_EQ(parse_authority("127.0.0.1:0443")->port, 443);
    EXPECT_EQ(parse_authority("")->host, "");
    EXPECT_EQ(parse_authority("a%2Db")->host, "a%2db");
}

TEST(Authority, OfAnIpv6AddressHasOneForm) {
    EXPECT_EQ(parse_authority("[::1]")->host, "[::1]");
    EXPECT_EQ(parse_authority("[2001:DB8:0:0::1]:443")->host, "[2001:db8::1]");
    EXPECT_EQ(parse_authority("[2001:DB8:0:0::1]:443")->port, 443);
}

TEST(Authority, ThatIsNoneIsRefused) {
    for (const char* text : {"a b", "user@host", "host:port", "host:65536", "host:1:2", "host:-1",
                             "::1", "[::1", "[::1]x", "[::1]x:80", "[]", "[name]", "a/b", "a?b",
                             "%zz", "a%2", "a,\x01", "h\xC3\xB6st", "host:80 "})
        EXPECT_FALSE(parse_authority(text)) << text;
}

TEST(OwnOrigin, HasTheHostAndThePortOfTheHostField) {
    EXPECT_TRUE(is_own_origin("http://name:8080", "name:8080"));
    EXPECT_TRUE(is_own_origin("https://NAME:8080", "Name:8080"));
    EXPECT_TRUE(is_own_origin("http://[0::1]:8080", "[::1]:8080"));
    EXPECT_FALSE(is_own_origin("http://name:8080", "name:8081"));
    EXPECT_FALSE(is_own_origin("http://other:8080", "name:8080"));
    EXPECT_FALSE(is_own_origin("http://name", "name.evil"));
}

TEST(OwnOrigin, OfTheDefaultPortOfItsSchemeIsTheSameAsWithoutAPort) {
    for (const char* host : {"name", "name:"}) {
        for (const char* origin :
             {"https://name", "https://name:443", "http://name", "http://name:80", "HTTPS://Name"})
            EXPECT_TRUE(is_own_origin(origin, host)) << origin << " at " << host;
        for (const char* origin : {"https://name:80", "http://name:443", "https://name:8443"})
            EXPECT_FALSE(is_own_origin(origin, host)) << origin << " at " << host;
    }
    EXPECT_TRUE(is_own_origin("https://name", "name:443"));
    EXPECT_TRUE(is_own_origin("https://name:443", "name:443"));
    EXPECT_FALSE(is_own_origin("http://name", "name:443"));
    EXPECT_TRUE(is_own_origin("http://name", "name:80"));
    EXPECT_TRUE(is_own_origin("http://name:80", "name:80"));
    EXPECT_TRUE(is_own_origin("https://[::1]", "[::1]:443"));
    EXPECT_TRUE(is_own_origin("https://[::1]:443", "[::1]"));
}

TEST(OwnOrigin, OfTlsMayStandBeforeAHostFieldWithThePortOfPlainHttp) {
    EXPECT_TRUE(is_own_origin("https://name", "name:80"));
    EXPECT_FALSE(is_own_origin("https://name:8443", "name:80"));
}

TEST(OwnOrigin, IsNoneWhereEitherCannotBeRead) {
    for (const char* origin : {"null", "", "name", "://name", "https://", "https://a b", "file://"})
        EXPECT_FALSE(is_own_origin(origin, "name")) << origin;
    EXPECT_FALSE(is_own_origin("https://name", ""));
    EXPECT_FALSE(is_own_origin("https://name", "name name"));
    EXPECT_FALSE(is_own_origin("app://name", "name"));
    EXPECT_FALSE(is_own_origin("app://name:8080", "name:8080"));
}

TEST(SameOrigin, TakesTheDefaultPortForNone) {
    EXPECT_TRUE(is_same_origin("https://club.example:443", "https://club.example"));
    EXPECT_TRUE(is_same_origin("HTTP://club.example", "http://CLUB.example:80"));
    EXPECT_FALSE(is_same_origin("https://club.example", "http://club.example"));
    EXPECT_FALSE(is_same_origin("https://club.example:80", "https://club.example"));
    EXPECT_TRUE(is_same_origin("null", "null"));
}

}  // namespace
}  // namespace poolhall::server
