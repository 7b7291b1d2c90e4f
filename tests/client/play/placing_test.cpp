#include "client/play/placing.hpp"

#include "client/play/cue_ball.hpp"
#include "client/play/local_match.hpp"
#include "tests/client/play/fixtures.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

class PlacingTest : public ::testing::Test {
  protected:
    [[nodiscard]] Vec2 cue() const { return cue_ball_of(*match_.info().table); }

    Playback playback_{Pacing::kSteady};
    LocalMatch match_{practice_spec(kEndGameRules), {"Anna", "The house"}, playback_};
    Placing placing_{match_};
};

TEST_F(PlacingTest, BallUnderThePointerFollowsUntilItIsLetGo) {
    ASSERT_TRUE(placing_.take_up(cue() + Vec2{0.01, 0}));
    placing_.drag({0.3, 0.1});
    EXPECT_EQ(cue(), (Vec2{end_game::kBaseLineX, 0.1}));
    placing_.let_go();
    EXPECT_FALSE(placing_.dragging());
    placing_.drag({0.3, 0.2});
    EXPECT_EQ(cue().y, 0.1);
}

TEST_F(PlacingTest, PointerBesideTheBallTakesUpNothing) {
    EXPECT_FALSE(placing_.take_up(cue() + Vec2{0.04, 0}));
    EXPECT_FALSE(placing_.dragging());
}

TEST_F(PlacingTest, BallThatIsNotInHandIsNotTakenUp) {
    match_.make(Shoot{{.direction = {0, 1}}});
    EXPECT_FALSE(placing_.take_up(cue()));
}

}  // namespace
}  // namespace poolhall::client
