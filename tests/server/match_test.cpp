#include "server/room/match.hpp"

#include "shared/game/end_game.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using protocol::Phase;

constexpr MemberId kAda{1};
constexpr MemberId kBen{2};
constexpr Vec2 kSafe{-1, 0.02};

Match match() {
    return Match({"0123456789abcdef", "BCDFGH", &kEndGameRules, Seat{0}});
}

Match seated() {
    Match match = server::match();
    match.take_seat(Seat{0}, {"Ada", hash_token("a"), kAda});
    match.take_seat(Seat{1}, {"Ben", hash_token("b"), kBen});
    return match;
}

protocol::ShotEnded play(Match& match, Vec2 direction) {
    match.start_shot(match.rules().play(match.game(), {direction}), std::chrono::microseconds(14));
    return match.finish_shot();
}

/// Shoots until somebody has won; the search is over all shots that a seed of directions gives.
void play_to_the_end(Match& match) {
    for (int shot = 0; !match.game().over; ++shot) {
        ASSERT_LT(shot, 2000);
        play(match, {1, 0.001 * shot - 0.3});
    }
}

TEST(Match, WaitsUntilBothSeatsAreTaken) {
    Match match = server::match();
    EXPECT_EQ(match.phase(), Phase::kWaiting);
    match.take_seat(Seat{0}, {"Ada", hash_token("a"), kAda});
    EXPECT_EQ(match.phase(), Phase::kWaiting);
    EXPECT_EQ(match.open_seat(), Seat{1});
    match.take_seat(Seat{1}, {"Ben", hash_token("b"), kBen});
    EXPECT_EQ(match.phase(), Phase::kAiming);
    EXPECT_FALSE(match.open_seat());
}

TEST(Match, ShotRunsFromStartToFinishAndPassesTheTurn) {
    Match match = seated();
    const GameState before = match.game();
    ShotOutcome outcome = match.rules().play(before, {kSafe});
    const std::uint64_t hash = outcome.trace.hash;
    match.start_shot(std::move(outcome), {});
    EXPECT_EQ(match.phase(), Phase::kPlaying);
    EXPECT_EQ(match.game(), before) << "the state is the one before the shot until it ends";
    EXPECT_TRUE(match.table().live.has_value());
    const protocol::ShotEnded ended = match.finish_shot();
    EXPECT_EQ(ended.hash, hash);
    EXPECT_EQ(ended.shot, 1U);
    EXPECT_EQ(match.phase(), Phase::kAiming);
    EXPECT_EQ(match.game().turn, Seat{1});
    EXPECT_FALSE(match.table().live.has_value());
    EXPECT_EQ(match.table().ruling, ended.ruling);
}

TEST(Match, CueBallMayBePlacedBeforeTheFirstShotOnly) {
    Match match = seated();
    EXPECT_TRUE(match.table().may_place);
    match.place_cue_ball({end_game::kBaseLineX, 0.1});
    EXPECT_EQ(match.cue_ball(), (Vec2{end_game::kBaseLineX, 0.1}));
    EXPECT_EQ(match.aim(), match.rules().default_aim(match.game()));
    play(match, kSafe);
    EXPECT_FALSE(match.table().may_place);
}

TEST(Match, RematchChangesSidesAndKeepsTheWins) {
    Match match = seated();
    play_to_the_end(match);
    ASSERT_EQ(match.phase(), Phase::kOver);
    const Seat winner = *match.game().winner;
    EXPECT_EQ(match.table().seats[winner.value].wins, 1U);
    match.vote_rematch(Seat{0});
    EXPECT_TRUE(match.table().seats[0].wants_rematch);
    match.start_next_game();
    EXPECT_EQ(match.phase(), Phase::kAiming);
    EXPECT_EQ(match.game().turn, Seat{1});
    EXPECT_EQ(match.game_number(), 2U);
    EXPECT_FALSE(match.table().seats[0].wants_rematch);
    EXPECT_FALSE(match.table().ruling.has_value());
    EXPECT_EQ(match.table().seats[winner.value].wins, 1U);
}

TEST(Match, EveryGameIsPlayedWithTheMatchsSettings) {
    const GameSettings settings = poolhall::test::pool_settings();
    Match match({"0123456789abcdef", "BCDFGH", &kEndGameRules, Seat{0}, settings});
    EXPECT_EQ(match.table().scene.effects, settings.effects);
    EXPECT_EQ(match.table().scene.solver, settings.solver);
    const protocol::ShotEnded ended = play(match, kSafe);
    EXPECT_EQ(ended.solver, SolverKind::kEvent);
    EXPECT_EQ(ended.kernel, "slide_roll_spin_end_game");
    EXPECT_EQ(match.table().scene.effects, settings.effects);
    match.start_next_game();
    EXPECT_EQ(match.game(), new_game(kEndGameRules, Seat{1}, settings));
}

TEST(Match, DisconnectedPlayerKeepsTheSeatAndComesBackByToken) {
    Match match = seated();
    match.disconnect(kAda);
    EXPECT_TRUE(match.table().seats[0].taken);
    EXPECT_FALSE(match.table().seats[0].connected);
    EXPECT_FALSE(match.holds(kAda, Seat{0}));
    constexpr MemberId kAgain{3};
    EXPECT_EQ(match.resume(hash_token("a"), kAgain), std::nullopt);
    EXPECT_TRUE(match.holds(kAgain, Seat{0}));
    constexpr MemberId kNewer{4};
    EXPECT_EQ(match.resume(hash_token("a"), kNewer), kAgain)
        << "the newer connection replaces the older";
}

TEST(Match, OneTokenCanHoldBothSeats) {
    Match match = server::match();
    match.take_seat(Seat{0}, {"Ada", hash_token("a"), kAda});
    match.take_seat(Seat{1}, *match.holder(Seat{0}));
    EXPECT_EQ(match.seats_of(kAda).size(), 2U);
    match.disconnect(kAda);
    match.resume(hash_token("a"), kBen);
    EXPECT_EQ(match.seats_of(kBen).size(), 2U);
}

TEST(Match, LeavingTheLastSeatMakesASpectator) {
    Match match = seated();
    match.leave_seat(Seat{0});
    EXPECT_EQ(match.phase(), Phase::kWaiting);
    EXPECT_EQ(match.spectators(), 1U);
    EXPECT_EQ(match.spectator_name(kAda), "Ada");
    match.leave(kAda);
    match.leave(kBen);
    EXPECT_EQ(match.spectators(), 0U);
    EXPECT_TRUE(match.deserted());
}

TEST(Match, NewHolderOfASeatBeginsWithoutWins) {
    Match match = seated();
    play_to_the_end(match);
    const Seat winner = *match.game().winner;
    match.leave_seat(winner);
    match.take_seat(winner, {"Cy", hash_token("c"), MemberId{9}});
    EXPECT_EQ(match.table().seats[winner.value].wins, 0U);
}

}  // namespace
}  // namespace poolhall::server
