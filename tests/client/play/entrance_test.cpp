#include "client/play/entrance.hpp"

#include "tests/client/play/fixtures.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

using namespace protocol;

template <class T>
const T* asked(const ClientBody& body) {
    const auto* entry = std::get_if<EntryCommand>(&body);
    return entry != nullptr ? std::get_if<T>(entry) : nullptr;
}

TEST(Entrance, NewMatchIsResumedByItsTokenAfterALoss) {
    TokensInMemory tokens;
    Entrance entrance({"h:1", "", "Anna"}, tokens);
    ASSERT_TRUE(asked<CreateMatch>(entrance.request()));
    entrance.entered({1, "t1", {Seat{0}}, new_table()});
    const ClientBody again = entrance.request();
    ASSERT_TRUE(asked<Resume>(again));
    EXPECT_EQ(asked<Resume>(again)->code, "BCDFGH");
    EXPECT_EQ(asked<Resume>(again)->token, "t1");
}

TEST(Entrance, SpectatorComesBackAsOne) {
    TokensInMemory tokens;
    Entrance entrance({"h:1", "BCDFGH", "Cleo", true}, tokens);
    ASSERT_TRUE(asked<WatchMatch>(entrance.request()));
    entrance.entered({1, "", {}, new_table()});
    EXPECT_TRUE(asked<WatchMatch>(entrance.request()));
}

TEST(Entrance, TokenOfAMatchThatIsGoneIsForgottenAndNothingElseTried) {
    TokensInMemory tokens;
    tokens.keep("h:1", "BCDFGH", "old");
    Entrance entrance({"h:1", "BCDFGH", "Anna"}, tokens);
    ASSERT_TRUE(asked<Resume>(entrance.request()));
    EXPECT_FALSE(entrance.request_after(RejectCode::kUnknownMatch));
    EXPECT_EQ(tokens.claim("h:1", "BCDFGH"), std::nullopt);
}

TEST(Entrance, RefusalThatHasNothingToDoWithTheTokenKeepsIt) {
    TokensInMemory tokens;
    tokens.keep("h:1", "BCDFGH", "old");
    Entrance entrance({"h:1", "BCDFGH", "Anna"}, tokens);
    ASSERT_TRUE(asked<Resume>(entrance.request()));
    EXPECT_FALSE(entrance.request_after(RejectCode::kServerFull));
    EXPECT_EQ(tokens.claim("h:1", "BCDFGH"), "old");
}

}  // namespace
}  // namespace poolhall::client
