#include "client/desktop/app/options.hpp"

#include "shared/game/end_game.hpp"
#include "tests/client/desktop_app/fixtures.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <string>
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

TEST(Options, PhysicsAreTheEffectsAndTheSolverOfAScene) {
    const std::string file = POOLHALL_SOURCE_DIR "/client/lab/scenes/draw.json";
    const auto options = parse({"--physics", file.c_str()});
    ASSERT_TRUE(options.ok()) << options.error().text;
    EXPECT_EQ(options->settings.solver->kind, SolverKind::kEvent);
    EXPECT_EQ(options->settings.effects->sliding, SlidingSpec{0.2});
    EXPECT_EQ(options->settings.effects->rail.model, RailModel::kHan2005);
    const auto at_a_server = parse({"--physics", file.c_str(), "--server", "ws://x"});
    ASSERT_TRUE(at_a_server.ok());
    EXPECT_EQ(at_a_server->settings, options->settings);
}

TEST(Options, PhysicsThatCannotBePlayedAreSaidInOneLine) {
    const TemporaryFolder folder;
    const std::string file = (folder.path / "scene.json").string();
    const auto refusal = [&](const std::string& text) {
        std::ofstream(file, std::ios::binary) << text;
        const auto options = parse({"--physics", file.c_str()});
        EXPECT_FALSE(options.ok());
        EXPECT_EQ(options.error().status, 2);
        const std::string start = "poolhall-client: --physics: " + file + ": ";
        EXPECT_EQ(options.error().text.find('\n'), std::string::npos) << options.error().text;
        EXPECT_TRUE(options.error().text.starts_with(start)) << options.error().text;
        return options.error().text.substr(std::min(start.size(), options.error().text.size()));
    };
    const auto scene = [](const std::string& effects, const std::string& solver) {
        return R"({"schema":"poolhall.scene/1","table":{"length":2,"width":1},"balls":[],"effects":)" +
               effects + R"(,"solver":)" + solver + "}";
    };
    EXPECT_EQ(refusal("").substr(0, 10), "is no JSON");
    EXPECT_EQ(refusal("{}"), "/schema is missing");
    EXPECT_EQ(refusal("[]"), "the scene must be an object");
    EXPECT_EQ(refusal(scene("{}", R"({"kind":"event"})")).substr(0, 9), "/effects ");
    EXPECT_EQ(refusal(scene(R"({"wind":{}})", R"({"kind":"event"})")),
              "/effects/wind is not known");
    EXPECT_EQ(refusal(scene(R"({"rolling":{"mu":-1}})", R"({"kind":"event"})")),
              "/effects/rolling/mu must be a finite number within its bounds");
    EXPECT_EQ(refusal(scene(R"({"rolling":{}})", R"({"kind":"overlap"})")).substr(0, 12),
              "/solver/kind");
    EXPECT_EQ(refusal(std::string((1U << 20U) + 1, ' ')), "is longer than 1 MiB");
    const std::string nowhere = (folder.path / "none.json").string();
    for (const std::string& path : {nowhere, folder.path.string()}) {
        const auto options = parse({"--physics", path.c_str()});
        ASSERT_FALSE(options.ok());
        EXPECT_TRUE(options.error().text.ends_with("cannot be read")) << options.error().text;
    }
    EXPECT_FALSE(parse({"--physics", file.c_str(), "--match", "BCDFGH"}).ok())
        << "a match that exists has its physics already";
}

TEST(Options, HelpNamesEveryOption) {
    const auto options = parse({"--help"});
    ASSERT_FALSE(options.ok());
    EXPECT_EQ(options.error().status, 0);
    for (const char* option : {"--server", "--match", "--watch", "--name", "--practice",
                               "--physics", "--encoding", "--screenshots"}) {
        EXPECT_NE(options.error().text.find(option), std::string::npos) << option;
    }
}

}  // namespace
}  // namespace poolhall::client
