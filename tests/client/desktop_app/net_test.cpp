#include "client/desktop/net/backoff.hpp"
#include "client/desktop/net/server_address.hpp"
#include "client/desktop/net/token_store.hpp"
#include "tests/client/desktop_app/fixtures.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace poolhall::client {
namespace {

using namespace std::chrono_literals;

TEST(Backoff, DoublesUpToEightSecondsWithJitter) {
    Backoff backoff(1);
    auto longest = 250ms;
    for (int attempt = 0; attempt < 12; ++attempt) {
        const auto pause = backoff.next();
        EXPECT_GE(pause, longest / 2);
        EXPECT_LE(pause, longest);
        longest = std::min(2 * longest, 8000ms);
    }
    backoff.reset();
    EXPECT_LE(backoff.next(), 250ms);
}

TEST(Backoff, TwoClientsDoNotComeBackTogether) {
    Backoff one(1);
    Backoff other(2);
    int different = 0;
    for (int attempt = 0; attempt < 10; ++attempt)
        different += one.next() != other.next() ? 1 : 0;
    EXPECT_GT(different, 7);
}

TEST(ServerAddress, TakesTheUsualForms) {
    const ServerAddress local{"127.0.0.1", "8081"};
    EXPECT_EQ(parse_server_address("ws://127.0.0.1:8081"), local);
    EXPECT_EQ(parse_server_address("http://127.0.0.1:8081/"), local);
    EXPECT_EQ(parse_server_address("127.0.0.1:8081"), local);
    EXPECT_EQ(parse_server_address("ws://127.0.0.1:8081/ws"), local);
    EXPECT_EQ(parse_server_address("pool.example"), (ServerAddress{"pool.example", "8080"}));
    EXPECT_EQ(parse_server_address("[::1]:9000"), (ServerAddress{"::1", "9000"}));
    EXPECT_EQ(parse_server_address("[::1]"), (ServerAddress{"::1", "8080"}));
    EXPECT_EQ(to_string({"::1", "9000"}), "[::1]:9000");
}

TEST(ServerAddress, RefusesTheRest) {
    for (const char* bad :
         {"", ":", "host:", "host:0", "host:65536", "host:80x", ":8080", "wss://host", "ftp://host",
          "ho st:80", "[::1", "[::1]x", "[]:80", "a:b:c"}) {
        EXPECT_FALSE(parse_server_address(bad)) << bad;
    }
}

class TokenStoreTest : public ::testing::Test {
  protected:
    TemporaryFolder folder_;
    std::filesystem::path state_ = folder_.path / "poolhall";
};

TEST_F(TokenStoreTest, TokenOutlivesTheProgramThatGotIt) {
    { TokenStore(state_).keep("h:1", "BCDFGH", "aa"); }
    TokenStore again(state_);
    EXPECT_EQ(again.claim("h:1", "BCDFGH"), "aa");
    EXPECT_EQ(again.claim("h:2", "BCDFGH"), std::nullopt);
    EXPECT_EQ(again.claim("h:1", "BCDFGJ"), std::nullopt);
}

TEST_F(TokenStoreTest, TokenInUseIsNotGivenToASecondClient) {
    TokenStore first(state_);
    first.keep("h:1", "BCDFGH", "aa");
    TokenStore second(state_);
    EXPECT_EQ(second.claim("h:1", "BCDFGH"), std::nullopt);
    second.keep("h:1", "BCDFGH", "bb");
    TokenStore third(state_);
    EXPECT_EQ(third.claim("h:1", "BCDFGH"), std::nullopt);
}

TEST_F(TokenStoreTest, ForgottenTokenIsGone) {
    TokenStore store(state_);
    store.keep("h:1", "BCDFGH", "aa");
    store.forget("aa");
    EXPECT_EQ(store.claim("h:1", "BCDFGH"), std::nullopt);
}

TEST_F(TokenStoreTest, OldTokensMakeRoom) {
    TokenStore store(state_);
    for (std::size_t i = 0; i <= TokenStore::kMaxTokens; ++i)
        store.keep("h:1", std::to_string(i), std::to_string(i));
    EXPECT_EQ(store.claim("h:1", "0"), std::nullopt);
    EXPECT_EQ(store.claim("h:1", "1"), "1");
}

TEST_F(TokenStoreTest, FileIsForItsOwnerOnly) {
    TokenStore store(state_);
    store.keep("h:1", "BCDFGH", "aa");

    struct stat info {};

    ASSERT_EQ(::stat((state_ / "tokens.json").c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777U, 0600U);
    ASSERT_EQ(::stat(state_.c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777U, 0700U);
}

TEST_F(TokenStoreTest, FileMayBeALinkAndStaysOne) {
    std::filesystem::create_directories(state_ / "elsewhere");
    std::filesystem::create_symlink("elsewhere/tokens.json", state_ / "tokens.json");
    for (const char* token : {"aa", "bb"}) {
        TokenStore(state_).keep("h:1", "BCDFGH", token);
        EXPECT_EQ(TokenStore(state_).claim("h:1", "BCDFGH"), token);
        EXPECT_TRUE(std::filesystem::is_symlink(state_ / "tokens.json"));
    }
}

TEST_F(TokenStoreTest, DamagedFileIsStartedAnew) {
    for (const char* text : {"", "{", "[1, null, {\"token\": 5}]", "{\"a\": 1}", "\xff\xfe"}) {
        std::filesystem::create_directories(state_);
        std::ofstream(state_ / "tokens.json", std::ios::trunc) << text;
        TokenStore store(state_);
        EXPECT_EQ(store.claim("h:1", "BCDFGH"), std::nullopt);
        store.keep("h:1", "BCDFGH", "aa");
        EXPECT_EQ(store.claim("h:1", "BCDFGH"), "aa");
    }
}

TEST_F(TokenStoreTest, WithoutAFolderTokensLastAsLongAsTheProcess) {
    std::ofstream(state_) << "a file where the folder should be";
    TokenStore store(state_);
    store.keep("h:1", "BCDFGH", "aa");
    EXPECT_EQ(store.claim("h:1", "BCDFGH"), "aa");
}

}  // namespace
}  // namespace poolhall::client
