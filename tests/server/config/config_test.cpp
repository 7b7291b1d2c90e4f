#include "server/config/config.hpp"

#include "tests/server/support/temp_folder.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <sstream>
#include <stdlib.h>

namespace poolhall::server {
namespace {

Result<ServerConfig, ConfigExit> load(const std::vector<std::string>& flags) {
    std::vector<const char*> argv{"poolhall-server"};
    for (const std::string& flag : flags)
        argv.push_back(flag.c_str());
    return load_config(static_cast<int>(argv.size()), argv.data());
}

class Config : public testing::Test {
  protected:
    std::string file(const std::string& text) {
        const std::string path = folder.str() + "/server.toml";
        std::ofstream(path) << text;
        return path;
    }

    /// The line that refuses the file.
    std::string refusal(const std::string& text) {
        const auto config = load({"--config", file(text)});
        if (config) return "accepted";
        EXPECT_EQ(config.error().status, 2);
        return config.error().text;
    }

    test::TempFolder folder;
};

TEST_F(Config, DefaultsServeThisMachineOnly) {
    const auto config = load({});
    ASSERT_TRUE(config.ok());
    EXPECT_EQ(config->listen, "127.0.0.1:8080");
    EXPECT_GE(config->threads, 1U);
    EXPECT_LE(config->threads, 4U);
}

TEST_F(Config, FileMayBeStandardInput) {
    std::istringstream text("threads = 3\nlisten = 5\n");
    std::streambuf* const input = std::cin.rdbuf(text.rdbuf());
    const auto config = load({"--config", "-"});
    std::cin.rdbuf(input);
    ASSERT_FALSE(config.ok());
    EXPECT_NE(config.error().text.find("-:2: listen "), std::string::npos) << config.error().text;
}

TEST_F(Config, FlagsComeBeforeEnvironmentAndThatBeforeTheFile) {
    const std::string path = file(
        "listen = '127.0.0.1:1'\ndata = 'file'\nthreads = 3\nallow-origin = ['https://a', "
        "'https://b']\n");
    ASSERT_EQ(setenv("POOLHALL_LISTEN", "127.0.0.1:2", 1), 0);
    ASSERT_EQ(setenv("POOLHALL_DATA", "environment", 1), 0);
    const auto config = load({"--config", path, "--listen", "127.0.0.1:3"});
    unsetenv("POOLHALL_LISTEN");
    unsetenv("POOLHALL_DATA");
    ASSERT_TRUE(config.ok()) << config.error().text;
    EXPECT_EQ(config->listen, "127.0.0.1:3");
    EXPECT_EQ(config->data, "environment");
    EXPECT_EQ(config->threads, 3U);
    EXPECT_EQ(config->allow_origin, (std::vector<std::string>{"https://a", "https://b"}));
}

TEST_F(Config, FileFaultsNameFileLineAndKey) {
    const std::string path = folder.str() + "/server.toml";
    EXPECT_EQ(refusal("# a comment\nlistne = 'x'\n"),
              "poolhall-server: " + path + ":2: unknown key 'listne'");
    EXPECT_EQ(refusal("threads = 'two'\n"),
              "poolhall-server: " + path + ":1: threads must be a whole number from 1 to 64");
    EXPECT_EQ(refusal("threads = 0\n"),
              "poolhall-server: " + path + ":1: threads must be a whole number from 1 to 64");
    EXPECT_EQ(refusal("listen = 8080\n"),
              "poolhall-server: " + path + ":1: listen must be a string");
    EXPECT_EQ(refusal("allow-origin = [1]\n"),
              "poolhall-server: " + path + ":1: allow-origin must be an array of strings");
    EXPECT_EQ(refusal("listen = \n").rfind("poolhall-server: " + path + ":1: ", 0), 0U);
    EXPECT_EQ(refusal("[server]\nlisten = 'x'\n"),
              "poolhall-server: " + path + ":1: unknown key 'server'");
}

TEST_F(Config, FileThatCannotBeReadIsNamed) {
    const auto config = load({"--config", "/nowhere/at/all.toml"});
    ASSERT_FALSE(config.ok());
    EXPECT_EQ(config.error().text, "poolhall-server: /nowhere/at/all.toml: cannot be read");
    const auto directory = load({"--config", folder.str()});
    EXPECT_FALSE(directory.ok());
}

TEST_F(Config, BadFlagsAreOneLine) {
    for (const std::vector<std::string>& flags : {std::vector<std::string>{"--frobnicate"},
                                                  {"--threads", "many"},
                                                  {"--threads", "0"},
                                                  {"--log-level", "loud"},
                                                  {"--max-matches", "-1"},
                                                  {"extra"},
                                                  {"--data", ""}}) {
        const auto config = load(flags);
        ASSERT_FALSE(config.ok()) << flags.front();
        EXPECT_EQ(config.error().status, 2);
        EXPECT_EQ(config.error().text.find('\n'), std::string::npos) << config.error().text;
    }
}

TEST_F(Config, HelpListsEverySetting) {
    const auto config = load({"--help"});
    ASSERT_FALSE(config.ok());
    EXPECT_EQ(config.error().status, 0);
    for (const char* name : {"--config", "--listen", "--data", "--threads", "--max-matches",
                             "--max-spectators", "--max-sessions", "--max-per-address",
                             "--idle-timeout", "--log-level", "--allow-origin", "--version"})
        EXPECT_NE(config.error().text.find(name), std::string::npos) << name;
}

}  // namespace
}  // namespace poolhall::server
