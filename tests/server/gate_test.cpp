#include "server/room/gate.hpp"

#include "shared/game/end_game.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using namespace protocol;

constexpr MemberId kAda{1};
constexpr MemberId kBen{2};
constexpr MemberId kSpectator{3};
constexpr std::uint32_t kMaxSpectators = 2;

class Gate : public testing::Test {
  protected:
    Gate() : match({"0123456789abcdef", "BCDFGH", &kEndGameRules, Seat{0}}) {
        match.take_seat(Seat{0}, {"Ada", hash_token("a"), kAda});
        match.take_seat(Seat{1}, {"Ben", hash_token("b"), kBen});
        match.watch(kSpectator, "Cy");
    }

    /// The code of the refusal, or "" for a command that may pass.
    std::string ask(MemberId member, const ClientBody& command) {
        const TableState before = match.table();
        const auto refusal = check(match, member, command, kMaxSpectators);
        EXPECT_EQ(match.table(), before) << "the gate changed something";
        return refusal ? std::string(name(refusal->code)) : std::string();
    }

    Match match;
};

TEST_F(Gate, PlayerWhoseTurnItIsMayAimPlaceAndShoot) {
    EXPECT_EQ(ask(kAda, Aim{Seat{0}, {1, 0}}), "");
    EXPECT_EQ(ask(kAda, PlaceCueBall{Seat{0}, {end_game::kBaseLineX, 0.1}}), "");
    EXPECT_EQ(ask(kAda, Shoot{Seat{0}, {1, 0}}), "");
}

TEST_F(Gate, OtherSeatHasToWait) {
    EXPECT_EQ(ask(kBen, Aim{Seat{1}, {1, 0}}), "not_your_turn");
    EXPECT_EQ(ask(kBen, PlaceCueBall{Seat{1}, {end_game::kBaseLineX, 0.1}}), "not_your_turn");
    EXPECT_EQ(ask(kBen, Shoot{Seat{1}, {1, 0}}), "not_your_turn");
}

TEST_F(Gate, NobodyPlaysForASeatOfAnother) {
    EXPECT_EQ(ask(kBen, Shoot{Seat{0}, {1, 0}}), "not_your_seat");
    EXPECT_EQ(ask(kSpectator, Shoot{Seat{0}, {1, 0}}), "not_your_seat");
    EXPECT_EQ(ask(kSpectator, LeaveSeat{Seat{0}}), "not_your_seat");
    EXPECT_EQ(ask(kSpectator, Rematch{Seat{0}}), "not_your_seat");
}

TEST_F(Gate, RulesRefuseWhatIsIllegal) {
    EXPECT_EQ(ask(kAda, PlaceCueBall{Seat{0}, {0, 0}}), "illegal");
    EXPECT_EQ(ask(kAda, Shoot{Seat{0}, {0, 0}}), "illegal");
}

TEST_F(Gate, NothingTouchesTheGameWhileAShotRuns) {
    match.start_shot(match.rules().play(match.game(), {{-1, 0.02}}), {});
    EXPECT_EQ(ask(kAda, Aim{Seat{0}, {1, 0}}), "wrong_phase");
    EXPECT_EQ(ask(kAda, PlaceCueBall{Seat{0}, {end_game::kBaseLineX, 0.1}}), "wrong_phase");
    EXPECT_EQ(ask(kAda, Shoot{Seat{0}, {1, 0}}), "wrong_phase");
    EXPECT_EQ(ask(kAda, LeaveSeat{Seat{0}}), "wrong_phase");
    EXPECT_EQ(ask(kAda, Leave{}), "wrong_phase");
    EXPECT_EQ(ask(kAda, Rematch{Seat{0}}), "wrong_phase");
    EXPECT_EQ(ask(kSpectator, Leave{}), "") << "a spectator may go at any time";
}

TEST_F(Gate, RematchIsForAGameThatIsOver) {
    EXPECT_EQ(ask(kAda, Rematch{Seat{0}}), "wrong_phase");
}

TEST_F(Gate, OpenSeatStopsTheGame) {
    match.leave_seat(Seat{1});
    EXPECT_EQ(ask(kAda, Shoot{Seat{0}, {1, 0}}), "wrong_phase");
    EXPECT_EQ(ask(kSpectator, TakeSeat{Seat{1}}), "");
    EXPECT_EQ(ask(kAda, TakeSeat{Seat{1}}), "");
    EXPECT_EQ(ask(MemberId{9}, JoinMatch{"BCDFGH", "Dee"}), "");
}

TEST_F(Gate, TakenSeatsCannotBeTaken) {
    EXPECT_EQ(ask(kSpectator, TakeSeat{Seat{1}}), "seat_taken");
    EXPECT_EQ(ask(kAda, TakeSeat{Seat{0}}), "seat_taken");
    EXPECT_EQ(ask(MemberId{9}, JoinMatch{"BCDFGH", "Dee"}), "match_full");
    match.disconnect(kBen);
    EXPECT_EQ(ask(MemberId{9}, JoinMatch{"BCDFGH", "Dee"}), "match_full") << "the seat is reserved";
}

TEST_F(Gate, SpectatorsAreLimited) {
    EXPECT_EQ(ask(MemberId{9}, WatchMatch{"BCDFGH", ""}), "");
    match.watch(MemberId{8}, "");
    EXPECT_EQ(ask(MemberId{9}, WatchMatch{"BCDFGH", ""}), "spectators_full");
}

TEST(GateToAMatch, KnowsTheGameAndItsSettings) {
    EXPECT_FALSE(check(CreateMatch{"Ada"}));
    EXPECT_FALSE(check(CreateMatch{"Ada", "end_game", {}, GameSettings{}}));
    EXPECT_FALSE(check(CreateMatch{"Ada", "end_game", {}, poolhall::test::pool_settings()}));
    EXPECT_EQ(check(CreateMatch{"Ada", "snooker"})->code, RejectCode::kUnknownGame);
}

TEST(GateToAMatch, NamesTheFieldOfUnfitSettings) {
    GameSettings settings = poolhall::test::pool_settings();
    settings.effects->sliding->mu = -0.2;
    const auto refusal = check(CreateMatch{"Ada", "end_game", {}, settings});
    ASSERT_TRUE(refusal);
    EXPECT_EQ(refusal->code, RejectCode::kBadField);
    EXPECT_EQ(refusal->reason,
              "field /settings/effects/sliding/mu must be a finite number within its bounds");
}

TEST_F(Gate, ResumeTakesTheTokenOfASeat) {
    EXPECT_EQ(ask(MemberId{9}, Resume{"BCDFGH", "a"}), "");
    EXPECT_EQ(ask(MemberId{9}, Resume{"BCDFGH", "c"}), "bad_token");
    match.leave_seat(Seat{0});
    EXPECT_EQ(ask(MemberId{9}, Resume{"BCDFGH", "a"}), "bad_token")
        << "a seat given up cannot be resumed";
}

}  // namespace
}  // namespace poolhall::server
