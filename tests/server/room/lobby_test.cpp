#include "server/room/lobby.hpp"

#include "tests/server/support/house.hpp"

#include <gtest/gtest.h>

namespace poolhall::server::test {
namespace {

using namespace protocol;
using std::chrono::milliseconds;

TEST(Lobby, MatchIsFoundByItsCodeOnly) {
    House house;
    Duel duel(house);
    Guest cy(house);
    EXPECT_EQ(cy.code_of(WatchMatch{"ZZZZZZ", ""}), "unknown_match");
    EXPECT_EQ(cy.code_of(JoinMatch{"ZZZZZZ", "Cy"}), "unknown_match");
    EXPECT_EQ(cy.code_of(Resume{"ZZZZZZ", duel.adas.token}), "unknown_match");
    EXPECT_EQ(cy.code_of(WatchMatch{duel.adas.table.code, ""}), "");
}

TEST(Lobby, WhoIsInAMatchEntersNoOther) {
    House house;
    Duel duel(house);
    EXPECT_EQ(duel.ada.code_of(CreateMatch{"Ada"}), "already_in_match");
    EXPECT_EQ(duel.ada.code_of(WatchMatch{duel.adas.table.code, ""}), "already_in_match");
    EXPECT_TRUE(duel.ada.standing().seated);
    EXPECT_EQ(house.lobby().size(), 1U);
}

TEST(Lobby, UnfitMatchesAreNotMade) {
    House house;
    Guest ada(house);
    EXPECT_EQ(ada.code_of(CreateMatch{"Ada", "snooker"}), "unknown_game");
    MatchSettings settings;
    settings.shot_clock_s = kMaxShotClock + 1;
    const auto reject = ada.ask(CreateMatch{"Ada", "end_game", {}, settings});
    ASSERT_TRUE(reject);
    EXPECT_EQ(reject->reason, "field /settings/shot_clock_s must be from 5 to 3600");
    EXPECT_EQ(house.lobby().size(), 0U);
}

TEST(Lobby, IsFullAtItsLimitUntilAMatchIsClosed) {
    House house({}, 1);
    Guest ada(house);
    Guest ben(house);
    ada.enter(CreateMatch{"Ada"});
    EXPECT_EQ(ben.code_of(CreateMatch{"Ben"}), "server_full");
    EXPECT_EQ(ada.code_of(Leave{}), "");
    EXPECT_EQ(house.counters().matches.load(), 0);
    EXPECT_EQ(ben.code_of(CreateMatch{"Ben"}), "");
}

TEST(Lobby, OnceClosedMakesNoMatchesAndKeepsThoseThatAre) {
    House house;
    Duel duel(house);
    house.lobby().close();
    Guest cy(house);
    EXPECT_EQ(cy.code_of(CreateMatch{"Cy"}), "shutting_down");
    EXPECT_EQ(cy.code_of(WatchMatch{duel.adas.table.code, ""}), "");
}

TEST(Lobby, SweepsMatchesThatNobodyCameBackTo) {
    RoomLimits limits;
    limits.idle_timeout = milliseconds(100);
    House house(limits);
    Duel duel(house);
    house.lobby().sweep();
    house.settle();
    EXPECT_EQ(house.lobby().size(), 1U) << "somebody is there";
    duel.ada.disconnect();
    duel.ben.disconnect();
    house.run_for(milliseconds(150));
    house.lobby().sweep();
    house.settle();
    EXPECT_EQ(house.lobby().size(), 0U);
}

TEST(Lobby, ListTellsTheCodeOnceNobodyCanJoin) {
    House house;
    Guest ada(house);
    const std::string code = ada.enter(CreateMatch{"Ada"}).table.code;
    ASSERT_EQ(house.lobby().list().size(), 1U);
    EXPECT_EQ(house.lobby().list()[0].code, "");
    Guest ben(house);
    ben.enter(JoinMatch{code, "Ben"});
    EXPECT_EQ(house.lobby().list()[0].code, code);
    EXPECT_EQ(house.lobby().list()[0].seats[1].name, "Ben");
    EXPECT_EQ(house.lobby().list()[0].phase, Phase::kAiming);
}

}  // namespace
}  // namespace poolhall::server::test
