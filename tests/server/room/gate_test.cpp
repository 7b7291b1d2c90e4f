#include "server/room/gate.hpp"

#include "tests/server/support/seated_table.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using namespace protocol;
using namespace test;

MakeMove shoot(Seat seat, Vec2 direction) {
    return {seat, Shoot{Stroke{direction, {}}}};
}

constexpr MemberId kSpectator{3};
constexpr std::uint32_t kMaxSpectators = 2;
constexpr Vec2 kOnBaseLine{end_game::kBaseLineX, 0.1};

class Gate : public testing::Test {
  protected:
    Gate() { table.roster.watch(kSpectator, "Cy"); }

    template <class Command>
    std::optional<Refusal> refusal(MemberId member, const Command& command) {
        const TableState before = state_of(table, 0);
        auto refusal = server::Gate(table, member, kMaxSpectators)(command);
        EXPECT_EQ(state_of(table, 0), before) << "the gate changed something";
        return refusal;
    }

    /// The code of the refusal, or "" for a command that may pass.
    template <class Command>
    std::string ask(MemberId member, const Command& command) {
        const auto refused = refusal(member, command);
        return refused ? std::string(name(refused->code)) : std::string();
    }

    std::string reason(const Move& move) {
        const auto refused = refusal(kAda, MakeMove{Seat{0}, move});
        return refused ? refused->reason : std::string();
    }

    Table table = seated_table();
};

TEST_F(Gate, PlayerWhoseTurnItIsMayAimPlaceAndShoot) {
    EXPECT_EQ(ask(kAda, Aim{Seat{0}, {1, 0}}), "");
    EXPECT_EQ(ask(kAda, MakeMove{Seat{0}, Place{kOnBaseLine}}), "");
    EXPECT_EQ(ask(kAda, shoot(Seat{0}, {1, 0})), "");
}

TEST_F(Gate, OtherSeatHasToWait) {
    EXPECT_EQ(ask(kBen, Aim{Seat{1}, {1, 0}}), "not_your_turn");
    EXPECT_EQ(ask(kBen, MakeMove{Seat{1}, Place{kOnBaseLine}}), "not_your_turn");
    EXPECT_EQ(ask(kBen, shoot(Seat{1}, {1, 0})), "not_your_turn");
}

TEST_F(Gate, NobodyPlaysForASeatOfAnother) {
    EXPECT_EQ(ask(kBen, shoot(Seat{0}, {1, 0})), "not_your_seat");
    EXPECT_EQ(ask(kSpectator, shoot(Seat{0}, {1, 0})), "not_your_seat");
    EXPECT_EQ(ask(kSpectator, LeaveSeat{Seat{0}}), "not_your_seat");
    EXPECT_EQ(ask(kSpectator, MakeMove{Seat{0}, Agree{}}), "not_your_seat");
}

TEST_F(Gate, RulesRefuseWhatIsIllegal) {
    EXPECT_EQ(ask(kAda, MakeMove{Seat{0}, Place{{0, 0}}}), "illegal");
    EXPECT_EQ(ask(kAda, shoot(Seat{0}, {0, 0})), "illegal");
}

TEST_F(Gate, NamesTheFieldThatTheRulesRefuse) {
    EXPECT_EQ(reason(Place{{0, 0}}),
              "field /move/position is no place where the cue ball may be put now");
    EXPECT_EQ(reason(Shoot{Stroke{{0, 0}, {}}}),
              "field /move/strike/direction must be finite and not zero");
    EXPECT_EQ(reason(Shoot{Stroke{{1, 0}, 99}}),
              "field /move/strike/speed is outside what the game allows");
    table.commit(shot_step(table, {-1, 0.02}), 0);
    table.commit(shot_step(table, {-1, 0.02}), 0);
    EXPECT_EQ(reason(Place{kOnBaseLine}), "field /move is no move that the rules offer now");
}

TEST_F(Gate, AimMayHoldTheCueBallWhileItIsInHand) {
    EXPECT_EQ(ask(kAda, Aim{Seat{0}, {1, 0}, kOnBaseLine}), "");
    EXPECT_EQ(ask(kAda, Aim{Seat{0}, {1, 0}, Vec2{0, 0}}), "") << "it is moved to where it may be";
    table.commit(shot_step(table, {-1, 0.02}), 0);
    EXPECT_EQ(ask(kBen, Aim{Seat{1}, {1, 0}, kOnBaseLine}), "illegal");
}

TEST_F(Gate, EitherSeatMayConcedeInAGameThatIsOn) {
    EXPECT_EQ(ask(kBen, MakeMove{Seat{1}, Concede{}}), "");
    EXPECT_EQ(ask(kAda, MakeMove{Seat{0}, Concede{}}), "");
    EXPECT_EQ(ask(kSpectator, MakeMove{Seat{0}, Concede{}}), "not_your_seat");
    table.commit(table.match.play(Seat{1}, Concede{}, 0), 0);
    EXPECT_EQ(ask(kAda, MakeMove{Seat{0}, Concede{}}), "wrong_phase");
}

TEST_F(Gate, NoSeatCallsTime) {
    MatchSettings settings;
    settings.shot_clock_s = 5;
    table = seated_table(settings);
    table.match.start_clock(0);
    EXPECT_EQ(ask(kAda, MakeMove{Seat{0}, TimeOut{}}), "illegal");
    EXPECT_EQ(ask(kBen, MakeMove{Seat{1}, TimeOut{}}), "illegal");
}

TEST_F(Gate, NothingTouchesTheGameWhileAShotRuns) {
    table.playout.emplace(shot_step(table, {-1, 0.02}), std::chrono::microseconds(1));
    EXPECT_EQ(ask(kAda, Aim{Seat{0}, {1, 0}}), "wrong_phase");
    EXPECT_EQ(ask(kAda, MakeMove{Seat{0}, Place{kOnBaseLine}}), "wrong_phase");
    EXPECT_EQ(ask(kAda, shoot(Seat{0}, {1, 0})), "wrong_phase");
    EXPECT_EQ(ask(kAda, LeaveSeat{Seat{0}}), "wrong_phase");
    EXPECT_EQ(ask(kAda, Leave{}), "wrong_phase");
    EXPECT_EQ(ask(kAda, MakeMove{Seat{0}, Agree{}}), "wrong_phase");
    EXPECT_EQ(ask(kSpectator, Leave{}), "") << "a spectator may go at any time";
}

TEST_F(Gate, RematchIsForAGameThatIsOver) {
    EXPECT_EQ(ask(kAda, MakeMove{Seat{0}, Agree{}}), "wrong_phase");
    table.commit(table.match.play(Seat{1}, Concede{}, 0), 0);
    EXPECT_EQ(ask(kAda, MakeMove{Seat{0}, Agree{}}), "");
}

TEST_F(Gate, OpenSeatStopsTheGame) {
    table.leave_seat(Seat{1});
    EXPECT_EQ(ask(kAda, shoot(Seat{0}, {1, 0})), "wrong_phase");
    EXPECT_EQ(ask(kSpectator, TakeSeat{Seat{1}}), "");
    EXPECT_EQ(ask(kAda, TakeSeat{Seat{1}}), "");
    EXPECT_EQ(ask(MemberId{9}, JoinMatch{"BCDFGH", "Dee"}), "");
}

TEST_F(Gate, TakenSeatsCannotBeTaken) {
    EXPECT_EQ(ask(kSpectator, TakeSeat{Seat{1}}), "seat_taken");
    EXPECT_EQ(ask(kAda, TakeSeat{Seat{0}}), "seat_taken");
    EXPECT_EQ(ask(MemberId{9}, JoinMatch{"BCDFGH", "Dee"}), "match_full");
    table.roster.disconnect(kBen);
    EXPECT_EQ(ask(MemberId{9}, JoinMatch{"BCDFGH", "Dee"}), "match_full") << "the seat is reserved";
}

TEST_F(Gate, SpectatorsAreLimited) {
    EXPECT_EQ(ask(MemberId{9}, WatchMatch{"BCDFGH", ""}), "");
    table.roster.watch(MemberId{8}, "");
    EXPECT_EQ(ask(MemberId{9}, WatchMatch{"BCDFGH", ""}), "spectators_full");
}

TEST(GateToAMatch, KnowsTheGameAndItsSettings) {
    EXPECT_FALSE(check(CreateMatch{"Ada"}));
    EXPECT_FALSE(check(CreateMatch{"Ada", "end_game", {}, MatchSettings{}}));
    EXPECT_FALSE(
        check(CreateMatch{"Ada", "end_game", {}, MatchSettings{poolhall::test::pool_settings()}}));
    EXPECT_EQ(check(CreateMatch{"Ada", "snooker"})->code, RejectCode::kUnknownGame);
}

TEST(GateToAMatch, NamesTheFieldOfUnfitSettings) {
    MatchSettings settings{poolhall::test::pool_settings()};
    settings.game.effects->sliding->mu = -0.2;
    const auto refusal = check(CreateMatch{"Ada", "end_game", {}, settings});
    ASSERT_TRUE(refusal);
    EXPECT_EQ(refusal->code, RejectCode::kBadField);
    EXPECT_EQ(refusal->reason,
              "field /settings/effects/sliding/mu must be a finite number within its bounds");
}

TEST_F(Gate, ResumeTakesTheTokenOfASeat) {
    EXPECT_EQ(ask(MemberId{9}, Resume{"BCDFGH", "a"}), "");
    EXPECT_EQ(ask(MemberId{9}, Resume{"BCDFGH", "c"}), "bad_token");
    table.leave_seat(Seat{0});
    EXPECT_EQ(ask(MemberId{9}, Resume{"BCDFGH", "a"}), "bad_token")
        << "a seat given up cannot be resumed";
}

}  // namespace
}  // namespace poolhall::server
