#include "shared/game/end_game.hpp"
#include "shared/match/settings.hpp"

#include <gtest/gtest.h>
#include <string>

namespace poolhall {
namespace {

/// What the check blames, "" if nothing.
std::string blamed(const MatchSettings& settings) {
    const auto error = check(kEndGameRules, settings);
    return error ? error->pointer : std::string();
}

TEST(MatchSettings, NoneAreFitForEveryGame) {
    EXPECT_EQ("", blamed({}));
}

TEST(MatchSettings, RaceIsToAtMostAThousandGames) {
    MatchSettings settings;
    settings.race_to = kMaxRace;
    EXPECT_EQ("", blamed(settings));
    settings.race_to = kMaxRace + 1;
    EXPECT_EQ("/race_to", blamed(settings));
}

TEST(MatchSettings, ShotClockGivesSecondsToAnHour) {
    MatchSettings settings;
    for (const std::uint32_t good : {kMinShotClock, kMaxShotClock}) {
        settings.shot_clock_s = good;
        EXPECT_EQ("", blamed(settings));
    }
    for (const std::uint32_t bad : {0U, kMinShotClock - 1, kMaxShotClock + 1}) {
        settings.shot_clock_s = bad;
        EXPECT_EQ("/shot_clock_s", blamed(settings));
    }
}

TEST(MatchSettings, PhysicsIsCheckedFirst) {
    MatchSettings settings;
    settings.race_to = kMaxRace + 1;
    settings.game.solver = SolverSpec{SolverKind::kOverlap, 30};
    EXPECT_EQ("/solver/kind", blamed(settings));
}

TEST(Names, OfBreakOrdersAndTurnsAreTheirCodes) {
    EXPECT_EQ("alternate", name(BreakOrder::kAlternate));
    EXPECT_EQ("winner", name(BreakOrder::kWinner));
    EXPECT_EQ("loser", name(BreakOrder::kLoser));
    EXPECT_EQ("shared", name(Turns::kShared));
    EXPECT_EQ("solo", name(Turns::kSolo));
}

}  // namespace
}  // namespace poolhall
