#include "client/play/ruling_text.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

std::string text(Verdict verdict, const std::string& shooter, std::string_view game = "end_game") {
    Ruling ruling;
    ruling.verdict = verdict;
    return ruling_text(game, ruling, shooter);
}

TEST(RulingText, EveryVerdictHasASentenceForTheShooterAndForTheOthers) {
    EXPECT_EQ(text(Verdict::kWon, "You"), "The 8-ball is down");
    EXPECT_EQ(text(Verdict::kScratch, "You"), "Scratch: you sank the cue ball");
    EXPECT_EQ(text(Verdict::kScratch, "Anna"), "Scratch: Anna sank the cue ball");
    EXPECT_EQ(text(Verdict::kConceded, "You"), "You gave the game up");
    EXPECT_EQ(text(Verdict::kConceded, "Anna"), "Anna gave the game up");
    EXPECT_EQ(text(Verdict::kTimedOut, "You"), "Your time is up: the turn passes");
    EXPECT_EQ(text(Verdict::kTimedOut, "Anna"), "Anna's time is up: the turn passes");
    EXPECT_EQ(text(Verdict::kTurnPasses, "Anna"), "The turn passes");
    for (const Verdict verdict : kValues<Verdict>)
        EXPECT_FALSE(text(verdict, "Anna").empty()) << name(verdict);
}

TEST(RulingText, GameThatIsNotKnownHereIsWonInGeneralWords) {
    EXPECT_EQ(text(Verdict::kWon, "You", "bar_billiards"), "The game is won");
}

}  // namespace
}  // namespace poolhall::client
