#include "client/play/words.hpp"

#include "client/play/local_match.hpp"
#include "tests/client/play/fixtures.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

using protocol::Phase;

/// A match that only says what the test has put into it.
class StillMatch : public ClientMatch {
  public:
    [[nodiscard]] const MatchInfo& info() const override { return content; }

    void poll(double /*now*/) override {}

    [[nodiscard]] double due_in(double /*now*/) const override { return 1; }

    [[nodiscard]] std::string take_notice() override { return ""; }

    void aim(Vec2 /*direction*/) override {}

    void hold_cue_ball(Vec2 /*position*/) override {}

    void make(const Move& /*move*/) override {}

    void toggle_hot_seat() override {}

    void retry_now() override {}

    MatchInfo content;
};

class WordsTest : public ::testing::Test {
  protected:
    WordsTest() {
        info().table = new_table();
        info().link = Link::kOnline;
        info().mine = {true, false};
    }

    MatchInfo& info() { return match_.content; }

    void end_game_with(const Ruling& ruling) {
        info().table->phase = Phase::kOver;
        info().table->ruling = ruling;
    }

    [[nodiscard]] std::string hint_now() {
        shown_.refresh();
        return hint(info(), shown_, false);
    }

    [[nodiscard]] Banner banner_now() {
        shown_.refresh();
        return banner(info(), shown_).value_or(Banner{"none", "", Tone::kNeutral});
    }

    StillMatch match_;
    Playback playback_{Pacing::kLive};
    ShownTable shown_{match_, playback_};
};

TEST_F(WordsTest, HintNamesTheKeysOfWhatIsLegal) {
    EXPECT_EQ(hint_now(),
              "Your turn: Up and Down place the cue ball, Left and Right aim, Space shoots");
    info().table->legal.place.reset();
    EXPECT_EQ(hint_now(), "Your turn: Left and Right aim, Space shoots");
}

TEST_F(WordsTest, HintSaysWhoseTurnItIs) {
    info().mine = {false, true};
    EXPECT_EQ(hint_now(), "Anna is aiming");
    info().table->seats[0].connected = false;
    EXPECT_EQ(hint_now(), "Anna has lost the connection; the seat is kept");
}

TEST_F(WordsTest, BannerSaysWhoWonAndWhy) {
    end_game_with({Verdict::kScratch, Seat{0}, Seat{1}, Seat{1}, 0});
    EXPECT_EQ(banner_now().title, "You lose");
    EXPECT_EQ(banner_now().subtitle, "Scratch: you sank the cue ball");
    EXPECT_EQ(banner_now().tone, Tone::kLost);
    info().mine = {};
    EXPECT_EQ(banner_now().title, "Ben wins");
    EXPECT_EQ(banner_now().subtitle, "Scratch: Anna sank the cue ball");
}

TEST_F(WordsTest, GameGivenUpIsWonByTheOther) {
    end_game_with({Verdict::kConceded, Seat{1}, Seat{0}, Seat{0}, 0});
    EXPECT_EQ(banner_now().title, "You win");
    EXPECT_EQ(banner_now().subtitle, "Ben gave the game up");
}

TEST_F(WordsTest, LastGameOfARaceWinsTheMatch) {
    info().table->winner = Seat{0};
    end_game_with({Verdict::kWon, Seat{0}, Seat{0}, Seat{0}, 0});
    EXPECT_EQ(banner_now().title, "You win the match");
    info().mine = {false, true};
    EXPECT_EQ(banner_now().title, "You lose the match");
}

TEST_F(WordsTest, TwoOfOneNameAreToldApartByTheirSeats) {
    info().mine = {};
    info().table->seats[1].name = "Anna";
    end_game_with({Verdict::kWon, Seat{1}, Seat{1}, Seat{1}, 0});
    EXPECT_EQ(banner_now().title, "Anna (right seat) wins");
}

TEST(ClockText, IsInSecondsBelowAMinute) {
    EXPECT_EQ(clock_text(0), "0 s");
    EXPECT_EQ(clock_text(59), "59 s");
    EXPECT_EQ(clock_text(65), "1:05 min");
    EXPECT_EQ(clock_text(3600), "60:00 min");
}

TEST_F(WordsTest, PhysicsAreTheSolverAndWhatTheLastShotCalledFor) {
    EXPECT_EQ(physics_of(info()), "euler 30 Hz");
    info().kernel = "slide_roll";
    info().effects = {{"sliding", {}, true}, {"airborne", Bound::kLevelCue, false}};
    EXPECT_EQ(physics_of(info()),
              "euler 30 Hz, slide_roll; called for: sliding. Ruled out: jump (level cue)");
}

TEST_F(WordsTest, PhysicsThatTheMatchChoseAreItsOwn) {
    EXPECT_FALSE(has_own_physics(info()));
    info().table->settings = MatchSettings{.game = {}, .race_to = 3};
    EXPECT_FALSE(has_own_physics(info()));
    info().table->settings->game.solver = SolverSpec{SolverKind::kEvent, 30};
    EXPECT_TRUE(has_own_physics(info()));
}

}  // namespace
}  // namespace poolhall::client
