#include "server/base/secret.hpp"

#include "protocol/limits.hpp"
#include "protocol/text.hpp"

#include <gtest/gtest.h>
#include <set>

namespace poolhall::server {
namespace {

TEST(Secret, TokensAreWellFormedAndNeverTheSame) {
    std::set<std::string> tokens;
    for (int i = 0; i < 1000; ++i)
        tokens.insert(new_token());
    EXPECT_EQ(tokens.size(), 1000U);
    for (const std::string& token : tokens)
        EXPECT_TRUE(protocol::is_token(token)) << token;
}

TEST(Secret, JoinCodesUseEveryLetterOfTheAlphabet) {
    std::set<char> letters;
    for (int i = 0; i < 1000; ++i) {
        const std::string code = new_join_code();
        EXPECT_EQ(code.size(), protocol::kCodeLetters);
        EXPECT_EQ(protocol::normalize_code(code), code);
        letters.insert(code.begin(), code.end());
    }
    EXPECT_EQ(letters.size(), protocol::kCodeAlphabet.size());
}

TEST(Secret, HashIsSha256) {
    EXPECT_EQ(hash_token("abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_TRUE(same_token(hash_token("abc"), hash_token("abc")));
    EXPECT_FALSE(same_token(hash_token("abc"), hash_token("abd")));
    EXPECT_FALSE(same_token(hash_token("abc"), ""));
}

}  // namespace
}  // namespace poolhall::server
