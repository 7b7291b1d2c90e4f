#include "server/http/request_target.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using Hosts = std::vector<std::string_view>;

/// "PATH at HOST", or the status of the refusal.
std::string read(std::string_view target, const Hosts& hosts, unsigned version = 11) {
    const auto result = read_target(version, target, hosts);
    return result ? result->path + " at " + result->host : std::to_string(result.error().status);
}

TEST(RequestTarget, IsThePathAtTheHostOfTheHostField) {
    EXPECT_EQ(read("/api/replays?limit=2", {"name:8080"}), "/api/replays?limit=2 at name:8080");
    EXPECT_EQ(read("/", {""}), "/ at ");
}

TEST(RequestTarget, OfAWholeUriCountsInsteadOfTheHostField) {
    EXPECT_EQ(read("http://name:8080/healthz", {"other"}), "/healthz at name:8080");
    EXPECT_EQ(read("HTTP://[::1]/ws?a=b", {"other"}), "/ws?a=b at [::1]");
    EXPECT_EQ(read("https://name", {"name"}), "/ at name");
    EXPECT_EQ(read("http://name?limit=2", {"name"}), "/?limit=2 at name");
    EXPECT_EQ(read("ws://name/ws", {"name"}), "/ws at name");
}

TEST(RequestTarget, OfAUriWithoutAHostIsRefused) {
    for (const char* target : {"http://", "http:///healthz", "http://user@name/", "http://a b/"})
        EXPECT_EQ(read(target, {"name"}), "400") << target;
}

TEST(RequestTarget, NeedsOneHostFieldFromVersion11On) {
    EXPECT_EQ(read("/healthz", {}), "400");
    EXPECT_EQ(read("http://name/healthz", {}), "400");
    EXPECT_EQ(read("/healthz", {}, 10), "/healthz at ");
}

TEST(RequestTarget, WithTwoHostFieldsIsRefusedEvenIfTheyAgree) {
    EXPECT_EQ(read("/healthz", {"name", "name"}), "400");
    EXPECT_EQ(read("/healthz", {"name", "other"}, 10), "400");
}

TEST(RequestTarget, WithAHostFieldThatIsNoneIsRefused) {
    for (const char* host : {"a b", "a,b/c", "user@name", "name:port", "[::1", "http://name"})
        EXPECT_EQ(read("/healthz", {host}), "400") << host;
}

}  // namespace
}  // namespace poolhall::server
