#include "client/desktop/app/options.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace poolhall::client {
namespace {

Result<Options, EarlyExit> parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "poolhall-client");
    return parse_options(static_cast<int>(arguments.size()), arguments.data());
}

TEST(Options, NothingMeansPractice) {
    const auto options = parse({"--name", "Anna"});
    ASSERT_TRUE(options.ok());
    EXPECT_FALSE(options->server);
    EXPECT_EQ(options->name, "Anna");
    EXPECT_EQ(options->width, 1280);
}

TEST(Options, ServerAloneMakesAMatchThere) {
    const auto options = parse({"--server", "http://hall.example:9000"});
    ASSERT_TRUE(options.ok());
    EXPECT_EQ(options->server, (ServerAddress{"hall.example", "9000"}));
    EXPECT_TRUE(options->code.empty());
}

TEST(Options, CodeAloneJoinsAtTheLocalServer) {
    const auto options = parse({"--match", "bcd-fgh", "--watch", "--encoding", "cbor"});
    ASSERT_TRUE(options.ok());
    EXPECT_EQ(options->code, "BCDFGH");
    EXPECT_TRUE(options->watch);
    EXPECT_EQ(options->encoding, protocol::Encoding::kCbor);
    EXPECT_EQ(options->server, (ServerAddress{"127.0.0.1", "8080"}));
}

TEST(Options, WhatIsWrongIsSaidInOneLine) {
    const std::vector<std::vector<const char*>> wrong = {
        {"--nonsense"},
        {"stray"},
        {"--server"},
        {"--server", "ftp://x"},
        {"--match", "12"},
        {"--watch"},
        {"--encoding", "xml"},
        {"--practice", "--server", "ws://x"},
        {"--practice", "--match", "bcdfgh"},
        {"--name", "\x1b[31m"},
        {"--name", "\xff"},
        {"--width", "0"},
        {"--name", "a name that is much longer than anybody could read"}};
    for (const auto& arguments : wrong) {
        const auto options = parse(arguments);
        ASSERT_FALSE(options.ok()) << arguments[0];
        EXPECT_EQ(options.error().status, 2);
        EXPECT_TRUE(options.error().text.starts_with("poolhall-client: ")) << options.error().text;
        EXPECT_EQ(options.error().text.find('\n'), std::string::npos) << options.error().text;
    }
}

TEST(Options, HelpNamesEveryOption) {
    const auto options = parse({"--help"});
    ASSERT_FALSE(options.ok());
    EXPECT_EQ(options.error().status, 0);
    for (const char* option : {"--server", "--match", "--watch", "--name", "--practice",
                               "--encoding", "--screenshots"}) {
        EXPECT_NE(options.error().text.find(option), std::string::npos) << option;
    }
}

}  // namespace
}  // namespace poolhall::client
