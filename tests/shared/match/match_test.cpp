#include "shared/match/match.hpp"

#include "tests/shared/match/matches.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace poolhall {
namespace {

using namespace test;

constexpr Seat kFirst{0};
constexpr Seat kSecond{1};

/// Why the match refuses the move, if it does.
std::optional<MoveFault> refused(const Match& match, Seat seat, const Move& move) {
    const auto refusal = match.find_fault(seat, move, kNow);
    return refusal ? std::optional(refusal->fault) : std::nullopt;
}

TEST(Match, BeginsWithTheRulesOwnNewGame) {
    const Match match(end_game_match({}, kSecond));
    const Position& now = match.now();
    EXPECT_EQ(kEndGameRules.new_game(kSecond), now.game);
    EXPECT_EQ(kEndGameRules.legal(now.game), now.legal);
    EXPECT_EQ(kSecond, now.first);
    EXPECT_EQ(1U, now.game_number);
    EXPECT_EQ(0U, now.shots);
    EXPECT_FALSE(now.ruling);
    EXPECT_FALSE(now.winner);
    EXPECT_EQ((PerSeat<std::uint32_t>{0, 0}), now.wins);
    EXPECT_TRUE(match.moves().empty());
}

TEST(Match, BeginsWithThePhysicsOfItsSettings) {
    MatchSettings settings;
    settings.game.solver = SolverSpec{SolverKind::kEvent, 30};
    Match match(end_game_match(settings));
    EXPECT_EQ(SolverKind::kEvent, match.now().game.scene.solver.kind);
    win(match, kFirst);
    EXPECT_EQ(SolverKind::kEvent, match.now().game.scene.solver.kind);
    EXPECT_EQ(kGameLimits, match.now().game.scene.limits);
}

TEST(Match, TakesMovesInTurn) {
    Match match(end_game_match());
    EXPECT_EQ(MoveFault::kNotYourTurn, refused(match, kSecond, kPass));
    EXPECT_EQ(MoveFault::kNotYourTurn, refused(match, kSecond, Place{}));
    make(match, kFirst, Place{{end_game::kBaseLineX, 0.1}});
    EXPECT_EQ(kFirst, match.now().legal.seat) << "who places goes on";
    make(match, kFirst, kPass);
    EXPECT_EQ(kSecond, match.now().legal.seat);
    EXPECT_EQ(MoveFault::kNotYourTurn, refused(match, kFirst, kPass));
    EXPECT_FALSE(refused(match, kSecond, kPass));
}

TEST(Match, RefusesWhatTheRulesRefuseAndSaysWhere) {
    const Match match(end_game_match());
    const auto place = match.find_fault(kFirst, Place{{0, 0}}, kNow);
    ASSERT_TRUE(place);
    EXPECT_EQ(MoveFault::kIllegal, place->fault);
    EXPECT_EQ((IllegalMove{Illegal::kOutOfRegion, "/position"}), place->illegal);
    const auto still = match.find_fault(kFirst, shot({0, 0}), kNow);
    ASSERT_TRUE(still);
    EXPECT_EQ((IllegalMove{Illegal::kBadDirection, "/strike/direction"}), still->illegal);
}

TEST(Match, TakesNothingButAgreementsOnceTheGameIsOver) {
    Match match(end_game_match());
    EXPECT_EQ(MoveFault::kNotOver, refused(match, kFirst, Agree{}));
    concede(match, kFirst);
    for (const Seat seat : kSeats) {
        for (const Move& move : {kPass, Move{Place{}}, Move{Concede{}}, Move{TimeOut{}}})
            EXPECT_EQ(MoveFault::kGameOver, refused(match, seat, move));
        EXPECT_FALSE(refused(match, seat, Agree{}));
    }
}

TEST(Match, PlayChangesNothingUntilItIsCommitted) {
    Match match(end_game_match());
    const Position before = match.now();
    const MatchStep step = match.play(kFirst, kPass, kNow);
    EXPECT_EQ(before, match.now());
    EXPECT_TRUE(match.moves().empty());
    EXPECT_NE(before, step.after);
    match.commit(step, kNow);
    EXPECT_EQ(step.after, match.now());
    EXPECT_EQ(std::vector{step.made}, match.moves());
}

TEST(Match, KeepsTheMoveCompletedWithItsTimeAndTheHashOfWhatItLedTo) {
    Match match(end_game_match());
    const MadeMove made = make(match, kFirst, kPass, kNow + 5).made;
    EXPECT_EQ(kFirst, made.seat);
    EXPECT_EQ(kNow + 5, made.at_ms);
    EXPECT_EQ(end_game::kShotSpeed, std::get<Shoot>(made.move).strike.speed);
    EXPECT_EQ(hash_of(match.now().game), made.state);
}

TEST(Match, TellsOfAShotAndThenOfItsRuling) {
    Match match(end_game_match());
    expect_events<CueBallPlaced>(make(match, kFirst, Place{{end_game::kBaseLineX, 0.1}}));
    const MatchStep step = make(match, kFirst, kPass);
    expect_events<ShotTaken, Ruled>(step);
    ASSERT_NE(nullptr, step.shot());
    EXPECT_EQ(1U, step.shot()->shot);
    EXPECT_EQ(Verdict::kTurnPasses, step.ruling().value().verdict);
    EXPECT_EQ(step.ruling(), match.now().ruling);
    make(match, kSecond, shot({0, 1}));
    EXPECT_EQ(2U, match.now().shots);
}

TEST(Match, TellsOfTheEndOfAGameThenOfTheRaceThenOfTheNextGame) {
    MatchSettings settings;
    settings.race_to = 2;
    Match match(end_game_match(settings));
    expect_events<Ruled, GameWon>(concede(match, kFirst));
    make(match, kFirst, Agree{});
    const MatchStep second = make(match, kSecond, Agree{});
    expect_events<Consented, GameBegan>(second);
    EXPECT_EQ(2U, std::get<GameBegan>(second.events[1]).game_number);
    expect_events<Ruled, GameWon, MatchWon>(concede(match, kFirst));
}

TEST(Match, MayBeConcededByEitherSeatWhoseverTurnItIs) {
    for (const Seat loser : kSeats) {
        Match match(end_game_match());
        const MatchStep step = concede(match, loser);
        EXPECT_EQ((Ruling{Verdict::kConceded, loser, opponent(loser), opponent(loser), 0}),
                  step.ruling());
        EXPECT_TRUE(match.now().game.over);
        EXPECT_EQ(opponent(loser), match.now().game.winner);
        EXPECT_EQ(1U, match.now().wins[opponent(loser).value]);
        EXPECT_EQ(0U, match.now().wins[loser.value]);
    }
}

TEST(Match, BeginsTheNextGameWhenBothSeatsWantIt) {
    Match match(end_game_match());
    make(match, kFirst, kPass);
    concede(match, kFirst);
    expect_events<Consented>(make(match, kSecond, Agree{}));
    EXPECT_EQ((PerSeat<bool>{false, true}), match.now().consents);
    expect_events<Consented>(make(match, kSecond, Agree{}));
    EXPECT_TRUE(match.now().game.over) << "one seat's consent given twice is not two";
    make(match, kFirst, Agree{});
    const Position& now = match.now();
    EXPECT_EQ(kEndGameRules.new_game(kSecond), now.game);
    EXPECT_EQ(2U, now.game_number);
    EXPECT_EQ(1U, now.shots) << "of the match, not of the game";
    EXPECT_EQ((PerSeat<bool>{false, false}), now.consents);
    EXPECT_EQ((PerSeat<std::uint32_t>{0, 1}), now.wins);
    EXPECT_FALSE(now.ruling);
}

TEST(Match, HasNoEndWithoutARace) {
    Match match(end_game_match());
    for (int game = 0; game < 20; ++game)
        win(match, kFirst);
    EXPECT_EQ(20U, match.now().wins[0]);
    EXPECT_FALSE(match.now().winner);
}

TEST(Match, IsWonByWhoFirstHasTheGamesOfTheRace) {
    MatchSettings settings;
    settings.race_to = 3;
    Match match(end_game_match(settings));
    win(match, kFirst);
    win(match, kSecond);
    win(match, kFirst);
    EXPECT_FALSE(match.now().winner);
    concede(match, kSecond);
    EXPECT_EQ(kFirst, match.now().winner);
    EXPECT_EQ((PerSeat<std::uint32_t>{3, 1}), match.now().wins);
    rematch(match);
    EXPECT_FALSE(match.now().winner) << "the next game begins the next race";
    EXPECT_EQ((PerSeat<std::uint32_t>{0, 0}), match.now().wins);
    EXPECT_EQ(5U, match.now().game_number);
}

/// Who breaks in each of the games after the first, which are won by seat 0, 0, 1 and 1.
std::vector<Seat> breakers(BreakOrder order) {
    MatchSettings settings;
    settings.breaks = order;
    Match match(end_game_match(settings));
    std::vector<Seat> firsts;
    for (const Seat winner : {kFirst, kFirst, kSecond, kSecond}) {
        concede(match, opponent(winner));
        const Seat next = match.next_first();
        rematch(match);
        EXPECT_EQ(next, match.now().first);
        EXPECT_EQ(next, match.now().legal.seat);
        firsts.push_back(next);
    }
    return firsts;
}

TEST(Match, BreaksAlternateOrFallToWinnerOrLoser) {
    EXPECT_EQ((std::vector{kSecond, kFirst, kSecond, kFirst}), breakers(BreakOrder::kAlternate));
    EXPECT_EQ((std::vector{kFirst, kFirst, kSecond, kSecond}), breakers(BreakOrder::kWinner));
    EXPECT_EQ((std::vector{kSecond, kSecond, kFirst, kFirst}), breakers(BreakOrder::kLoser));
}

TEST(SoloMatch, LeavesEveryTurnToSeatNought) {
    MatchSettings settings;
    settings.turns = Turns::kSolo;
    Match match(end_game_match(settings, kSecond));
    EXPECT_EQ(kFirst, match.now().legal.seat) << "whoever was to break";
    const MatchStep step = make(match, kFirst, kPass);
    EXPECT_EQ(kFirst, match.now().legal.seat);
    EXPECT_EQ(kFirst, match.now().game.turn);
    EXPECT_EQ(kFirst, step.ruling().value().next);
    EXPECT_EQ(MoveFault::kNotYourTurn, refused(match, kSecond, kPass));
    EXPECT_EQ(hash_of(match.now().game), step.made.state);
}

TEST(SoloMatch, IsPlayedAgainByTheConsentOfOne) {
    MatchSettings settings;
    settings.turns = Turns::kSolo;
    settings.race_to = 1;
    Match match(end_game_match(settings));
    concede(match, kFirst);
    EXPECT_EQ(kSecond, match.now().winner) << "a game lost is won by the other seat";
    expect_events<Consented, GameBegan>(make(match, kFirst, Agree{}));
    EXPECT_EQ(kFirst, match.now().first);
}

TEST(Match, SeatThatSomebodyElseTakesBeginsAnew) {
    Match match(end_game_match());
    win(match, kFirst);
    concede(match, kFirst);
    make(match, kFirst, Agree{});
    const Position before = match.now();
    match.reset_seat(kFirst);
    Position expected = before;
    expected.wins = {0, 1};
    expected.consents = {};
    EXPECT_EQ(expected, match.now()) << "the game and the other seat are as they were";
    make(match, kSecond, Agree{});
    EXPECT_TRUE(match.now().game.over);
    make(match, kFirst, Agree{});
    EXPECT_EQ((PerSeat<std::uint32_t>{0, 1}), match.now().wins);
}

TEST(Match, GoesOnFromAStepThatWasRecordedElsewhere) {
    Match match(end_game_match());
    const Turn other = kEndGameRules.play(match.now().game, completed(match.now().legal, kPass));
    Turn turn = other;
    turn.shot.reset();
    turn.state.scene.balls[0].state.r.y += 0.01;  // as another edition of the physics had it
    const MadeMove made{kFirst, completed(match.now().legal, kPass), kNow, hash_of(turn.state)};
    match.commit(match.recorded(made, turn), kNow);
    EXPECT_EQ(turn.state, match.now().game);
    EXPECT_EQ(kSecond, match.now().legal.seat);
    EXPECT_EQ(std::vector{made}, match.moves());
    EXPECT_EQ(match.now(), match.at(1)) << "not what the move gives today";
    make(match, kSecond, shot({0, 1}));
    EXPECT_EQ(match.now(), match.at(2));
}

}  // namespace
}  // namespace poolhall
