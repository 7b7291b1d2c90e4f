#include "server/room/room.hpp"

#include "server/room/rebuild.hpp"
#include "shared/game/end_game.hpp"
#include "tests/server/support/house.hpp"

#include <gtest/gtest.h>

namespace poolhall::server::test {
namespace {

using namespace protocol;
using std::chrono::milliseconds;

const Vec2 kScratch{-end_game::kLength / 2 - end_game::kBaseLineX, end_game::kWidth / 2};
constexpr Vec2 kPlace{end_game::kBaseLineX, 0.1};

/// The moves that the log has.
std::vector<Move> logged_moves(House& house) {
    std::vector<Move> moves;
    for (const ReplayRecord& record : house.stored().records)
        if (const auto* move = std::get_if<MoveRecord>(&record)) moves.push_back(move->move);
    return moves;
}

/// The match as a server would go on with it that starts now.
Position after_a_crash(House& house) {
    const auto table = rebuild(house.stored());
    if (!table) throw std::runtime_error(table.error());
    return table->match.now();
}

MatchSettings with_clock(std::uint32_t seconds) {
    MatchSettings settings;
    settings.shot_clock_s = seconds;
    return settings;
}

TEST(Room, PlacementIsLoggedAndShownToAll) {
    House house;
    Duel duel(house);
    EXPECT_EQ(duel.ada.code_of(MakeMove{Seat{0}, Place{kPlace}}), "");
    EXPECT_EQ(logged_moves(house), std::vector<Move>{Place{kPlace}});
    EXPECT_EQ(xy(duel.ben.table().state.scene.balls[0].state.r), kPlace);
    EXPECT_EQ(duel.ben.table().aim, duel.ben.table().legal.aim);
}

TEST(Room, AimIsShownAndDecidesNothing) {
    House house;
    Duel duel(house);
    const GameState before = duel.ada.table().state;
    EXPECT_EQ(duel.ada.code_of(Aim{Seat{0}, {0.5, 0.5}, Vec2{0.3, 9}}), "");
    const AimChanged* aim = duel.ben.newest<AimChanged>();
    ASSERT_NE(aim, nullptr);
    EXPECT_EQ(aim->direction, (Vec2{0.5, 0.5}));
    EXPECT_EQ(aim->cue, nearest_place(*duel.ada.table().legal.place, {0.3, 9}))
        << "the cue ball is held where it may be put";
    EXPECT_TRUE(logged_moves(house).empty());
    Guest cy(house);
    const TableState seen = cy.enter(WatchMatch{duel.adas.table.code, ""}).table;
    EXPECT_EQ(seen.state, before);
    EXPECT_EQ(seen.aim, (Vec2{0.5, 0.5}));
    EXPECT_EQ(seen.cue, aim->cue);
    EXPECT_EQ(duel.ada.code_of(MakeMove{Seat{0}, Place{kPlace}}), "");
    EXPECT_FALSE(duel.ben.table().cue) << "after a placement nobody holds the ball";
}

TEST(Room, ShotIsLoggedAtOnceAndTheTableFollowsWhenItHasBeenShown) {
    House house;
    Duel duel(house);
    EXPECT_EQ(duel.ada.code_of(shoot(Seat{0}, kScratch)), "");
    ASSERT_NE(duel.ben.newest<ShotStarted>(), nullptr);
    EXPECT_EQ(logged_moves(house).size(), 1U);
    Guest cy(house);
    const TableState running = cy.enter(WatchMatch{duel.adas.table.code, ""}).table;
    EXPECT_EQ(running.phase, Phase::kPlaying);
    EXPECT_EQ(running.state, duel.adas.table.state);
    ASSERT_TRUE(house.run_until([&] { return duel.ben.newest<ShotEnded>() != nullptr; }));
    EXPECT_EQ(duel.ben.table().phase, Phase::kOver);
    EXPECT_EQ(duel.ben.table().state, after_a_crash(house).game);
    EXPECT_EQ(duel.ben.newest<ShotEnded>()->ruling.verdict, Verdict::kScratch);
}

TEST(Room, ConcessionGivesTheGameToTheOther) {
    House house;
    Duel duel(house);
    EXPECT_EQ(duel.ben.code_of(MakeMove{Seat{1}, Concede{}}), "") << "out of turn, too";
    EXPECT_EQ(duel.ada.table().phase, Phase::kOver);
    EXPECT_EQ(duel.ada.table().state.winner, Seat{0});
    EXPECT_EQ(duel.ada.table().ruling->verdict, Verdict::kConceded);
    EXPECT_EQ(duel.ada.table().seats[0].wins, 1U);
}

TEST(Room, RematchBeginsWhenBothAgreeAndTheOtherSeatBreaks) {
    House house;
    Duel duel(house);
    EXPECT_EQ(duel.ada.code_of(MakeMove{Seat{0}, Agree{}}), "wrong_phase");
    EXPECT_EQ(duel.ada.code_of(MakeMove{Seat{0}, Concede{}}), "");
    EXPECT_EQ(duel.ada.code_of(MakeMove{Seat{0}, Agree{}}), "");
    EXPECT_TRUE(duel.ben.table().seats[0].wants_rematch);
    EXPECT_EQ(duel.ben.code_of(MakeMove{Seat{1}, Agree{}}), "");
    EXPECT_EQ(duel.ada.table().phase, Phase::kAiming);
    EXPECT_EQ(duel.ada.table().game_number, 2U);
    EXPECT_EQ(duel.ada.table().legal.seat, Seat{1});
    EXPECT_FALSE(duel.ada.table().ruling);
}

TEST(Room, RaceIsWonAndTheNextOneBeginsAtNothing) {
    House house;
    MatchSettings settings;
    settings.race_to = 2;
    settings.breaks = BreakOrder::kWinner;
    Duel duel(house, settings);
    for (std::uint32_t game = 1; game <= 2; ++game) {
        EXPECT_FALSE(duel.ada.table().winner);
        EXPECT_EQ(duel.ben.code_of(MakeMove{Seat{1}, Concede{}}), "");
        EXPECT_EQ(duel.ada.table().seats[0].wins, game);
        if (game == 2) break;
        for (const Seat seat : kSeats)
            EXPECT_EQ(duel.player(seat).code_of(MakeMove{seat, Agree{}}), "");
        EXPECT_EQ(duel.ada.table().legal.seat, Seat{0}) << "the winner breaks";
    }
    EXPECT_EQ(duel.ben.table().winner, Seat{0});
    for (const Seat seat : kSeats)
        EXPECT_EQ(duel.player(seat).code_of(MakeMove{seat, Agree{}}), "");
    EXPECT_FALSE(duel.ben.table().winner);
    EXPECT_EQ(duel.ben.table().seats[0].wins, 0U);
}

TEST(Room, ConsentIsKeptOverARestart) {
    House house;
    Duel duel(house);
    ASSERT_EQ(duel.ada.code_of(MakeMove{Seat{0}, Concede{}}), "");
    ASSERT_EQ(duel.ada.code_of(MakeMove{Seat{0}, Agree{}}), "");
    auto table = rebuild(house.stored());
    ASSERT_TRUE(table.ok()) << table.error();
    const std::string code = table->code = "ZZZZZZ";
    house.lobby().reopen(*std::move(table));
    Guest ben(house);
    EXPECT_TRUE(ben.enter(Resume{code, duel.bens.token}).table.seats[0].wants_rematch);
    EXPECT_EQ(ben.code_of(MakeMove{Seat{1}, Agree{}}), "");
    EXPECT_EQ(ben.table().game_number, 2U);
}

// ---- a server that ends in the middle of a move

/// What a crash leaves before the players hear of the move, once it is durable; and that a server
/// that goes on has it the same.
void expect_move_survives(House& house, Duel& duel, const MakeMove& move) {
    const Position before = after_a_crash(house);
    Guest& player = duel.player(move.seat);
    player.send(move);
    house.run_to_the_store();
    const Position crashed = after_a_crash(house);
    EXPECT_NE(crashed, before);
    house.settle();
    const bool shown = house.run_until([&] { return player.table().phase != Phase::kPlaying; });
    EXPECT_TRUE(shown);
    EXPECT_EQ(player.table().state, crashed.game);
    EXPECT_EQ(player.table().legal, crashed.legal);
}

TEST(RoomCrash, PlacementThatWasDurableIsPartOfTheMatch) {
    House house;
    Duel duel(house);
    expect_move_survives(house, duel, {Seat{0}, Place{kPlace}});
}

TEST(RoomCrash, ConcessionThatWasDurableIsPartOfTheMatch) {
    House house;
    Duel duel(house);
    expect_move_survives(house, duel, {Seat{1}, Concede{}});
}

TEST(RoomCrash, ConsentThatWasDurableIsPartOfTheMatch) {
    House house;
    Duel duel(house);
    ASSERT_EQ(duel.ada.code_of(MakeMove{Seat{0}, Concede{}}), "");
    expect_move_survives(house, duel, {Seat{0}, Agree{}});
    expect_move_survives(house, duel, {Seat{1}, Agree{}});
}

TEST(RoomCrash, ShotThatWasDurableIsPartOfTheMatch) {
    House house;
    Duel duel(house);
    duel.ada.send(shoot(Seat{0}, kScratch));
    house.run_to_the_store();
    const Position crashed = after_a_crash(house);
    EXPECT_TRUE(crashed.game.over);
    house.settle();
    ASSERT_TRUE(house.run_until([&] { return duel.ada.newest<ShotEnded>() != nullptr; }));
    EXPECT_EQ(duel.ada.table().state, crashed.game);
}

// ---- the shot clock

TEST(RoomClock, TurnPassesWhenItHasRunDown) {
    House house;
    Duel duel(house, with_clock(kMinShotClock));
    ASSERT_TRUE(duel.ben.table().clock_left_ms.has_value());
    EXPECT_LE(*duel.ben.table().clock_left_ms, 1000 * kMinShotClock);
    EXPECT_GT(*duel.ben.table().clock_left_ms, 1000 * (kMinShotClock - 1));
    const auto start = LoopTimer::Clock::now();
    ASSERT_TRUE(house.run_until([&] { return duel.ben.table().legal.seat == Seat{1}; }));
    EXPECT_GE(LoopTimer::Clock::now() - start, milliseconds(1000 * kMinShotClock - 500));
    EXPECT_EQ(duel.ben.table().ruling->verdict, Verdict::kTimedOut);
    EXPECT_EQ(logged_moves(house), std::vector<Move>{TimeOut{}});
    EXPECT_EQ(after_a_crash(house).legal.seat, Seat{1});
    EXPECT_GT(*duel.ben.table().clock_left_ms, 1000 * (kMinShotClock - 1))
        << "the other seat has its own time";
}

TEST(RoomClock, PlacementGivesNoMoreTime) {
    House house;
    Duel duel(house, with_clock(kMinShotClock));
    house.run_for(milliseconds(600));
    ASSERT_EQ(duel.ada.code_of(MakeMove{Seat{0}, Place{kPlace}}), "");
    EXPECT_LE(*duel.ada.table().clock_left_ms, 1000 * kMinShotClock - 600);
}

TEST(RoomClock, BeginsAnewWhenAnOpenSeatIsTakenAgain) {
    House house;
    Duel duel(house, with_clock(kMinShotClock));
    house.run_for(milliseconds(600));
    ASSERT_EQ(duel.ben.code_of(LeaveSeat{Seat{1}}), "");
    EXPECT_FALSE(duel.ada.table().clock_left_ms) << "it stands while a seat is open";
    ASSERT_EQ(duel.ben.code_of(TakeSeat{Seat{1}}), "");
    EXPECT_GT(*duel.ada.table().clock_left_ms, 1000 * kMinShotClock - 500);
}

TEST(RoomClock, StandsWhileNoPlayerIsThereAndBeginsAnewWithTheFirst) {
    House house;
    Duel duel(house, with_clock(kMinShotClock));
    duel.ada.disconnect();
    duel.ben.disconnect();
    Guest cy(house);
    EXPECT_FALSE(cy.enter(WatchMatch{duel.adas.table.code, ""}).table.clock_left_ms);
    house.run_for(milliseconds(1000 * kMinShotClock + 300));
    EXPECT_TRUE(logged_moves(house).empty());
    Guest ben(house);
    const TableState back = ben.enter(Resume{duel.adas.table.code, duel.bens.token}).table;
    EXPECT_GT(*back.clock_left_ms, 1000 * kMinShotClock - 500);
}

TEST(RoomClock, StandsWhileAShotRuns) {
    House house;
    Duel duel(house, with_clock(kMinShotClock));
    house.run_for(milliseconds(300));
    // Rolls out in about 6 s, longer than the clock.
    ASSERT_EQ(duel.ada.code_of(shoot(Seat{0}, {-1, 0.02})), "");
    ASSERT_TRUE(house.run_until([&] { return duel.ada.newest<ShotEnded>() != nullptr; }));
    EXPECT_EQ(logged_moves(house).size(), 1U);
    EXPECT_GT(*duel.ada.table().clock_left_ms, 1000 * kMinShotClock - 500);
}

// ---- people

TEST(Room, NewerConnectionReplacesTheOlder) {
    House house;
    Duel duel(house);
    Guest newer(house);
    EXPECT_EQ(newer.enter(Resume{duel.adas.table.code, duel.adas.token}).seats,
              std::vector<Seat>{Seat{0}});
    EXPECT_TRUE(duel.ada.is_closed());
    EXPECT_EQ(newer.code_of(MakeMove{Seat{0}, Place{kPlace}}), "");
}

TEST(Room, LeavingSeatsAndTheMatchChangesWhereAMemberStands) {
    House house;
    Duel duel(house);
    EXPECT_TRUE(duel.ben.standing().seated);
    ASSERT_EQ(duel.ben.code_of(LeaveSeat{Seat{1}}), "");
    EXPECT_FALSE(duel.ben.standing().seated);
    EXPECT_NE(duel.ben.standing().room, nullptr);
    EXPECT_EQ(duel.ada.table().phase, Phase::kWaiting);
    ASSERT_EQ(duel.ben.code_of(Leave{}), "");
    EXPECT_EQ(duel.ben.standing().room, nullptr);
}

TEST(Room, RefusalLeavesAMemberWhereItStood) {
    House house;
    Duel duel(house);
    EXPECT_EQ(duel.ben.code_of(shoot(Seat{1}, {1, 0})), "not_your_turn");
    EXPECT_TRUE(duel.ben.standing().seated);
    EXPECT_NE(duel.ben.standing().room, nullptr);
    EXPECT_EQ(house.counters().rejects.load(), 1U);
}

}  // namespace
}  // namespace poolhall::server::test
