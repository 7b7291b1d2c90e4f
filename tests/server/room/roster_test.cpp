#include "server/room/roster.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

constexpr MemberId kAda{1};
constexpr MemberId kBen{2};

Roster seated() {
    Roster roster;
    roster.take_seat(Seat{0}, {"Ada", hash_token("a"), kAda});
    roster.take_seat(Seat{1}, {"Ben", hash_token("b"), kBen});
    return roster;
}

TEST(Roster, SeatsAreGivenInTheirOrder) {
    Roster roster;
    EXPECT_TRUE(roster.deserted());
    EXPECT_EQ(roster.open_seat(), Seat{0});
    roster.take_seat(Seat{0}, {"Ada", hash_token("a"), kAda});
    EXPECT_FALSE(roster.deserted());
    EXPECT_EQ(roster.open_seat(), Seat{1});
    roster.take_seat(Seat{1}, {"Ben", hash_token("b"), kBen});
    EXPECT_FALSE(roster.open_seat());
}

TEST(Roster, DisconnectedPlayerKeepsTheSeatAndComesBackByToken) {
    Roster roster = seated();
    roster.disconnect(kAda);
    EXPECT_EQ(roster.holder(Seat{0})->name, "Ada");
    EXPECT_FALSE(roster.holds(kAda, Seat{0}));
    constexpr MemberId kAgain{3};
    EXPECT_EQ(roster.resume(hash_token("a"), kAgain), std::nullopt);
    EXPECT_TRUE(roster.holds(kAgain, Seat{0}));
    constexpr MemberId kNewer{4};
    EXPECT_EQ(roster.resume(hash_token("a"), kNewer), kAgain)
        << "the newer connection replaces the older";
}

TEST(Roster, IsAttendedWhileAPlayerIsConnected) {
    Roster roster = seated();
    roster.watch(MemberId{3}, "Cy");
    roster.disconnect(kAda);
    EXPECT_TRUE(roster.attended());
    roster.disconnect(kBen);
    EXPECT_FALSE(roster.attended()) << "a spectator is no player";
}

TEST(Roster, OneTokenCanHoldBothSeats) {
    Roster roster;
    roster.take_seat(Seat{0}, {"Ada", hash_token("a"), kAda});
    roster.take_seat(Seat{1}, *roster.holder(Seat{0}));
    EXPECT_EQ(roster.seats_of(kAda).size(), 2U);
    roster.disconnect(kAda);
    roster.resume(hash_token("a"), kBen);
    EXPECT_EQ(roster.seats_of(kBen).size(), 2U);
}

TEST(Roster, LeavingTheLastSeatMakesASpectator) {
    Roster roster = seated();
    roster.leave_seat(Seat{0});
    EXPECT_EQ(roster.spectators(), 1U);
    EXPECT_EQ(roster.spectator_name(kAda), "Ada");
    EXPECT_TRUE(roster.leave(kAda).empty());
    EXPECT_EQ(roster.leave(kBen), std::vector<Seat>{Seat{1}});
    EXPECT_EQ(roster.spectators(), 0U);
    EXPECT_TRUE(roster.deserted());
}

TEST(Roster, SpectatorWhoTakesASeatWatchesNoMore) {
    Roster roster;
    roster.watch(kAda, "Ada");
    roster.take_seat(Seat{0}, {"Ada", hash_token("a"), kAda});
    EXPECT_EQ(roster.spectators(), 0U);
}

}  // namespace
}  // namespace poolhall::server
