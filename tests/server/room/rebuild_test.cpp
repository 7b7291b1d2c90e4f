#include "server/room/rebuild.hpp"

#include "shared/physics/edition.hpp"
#include "tests/server/support/seated_table.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using namespace protocol;
using namespace test;

constexpr Vec2 kSafe{-1, 0.02};

/// The log of a match as a server writes it, and the table that it is of.
struct Logged {
    explicit Logged(const MatchSettings& settings = {}) : table(seated_table(settings)) {
        stored.id = table.id;
        stored.code = table.code;
        stored.seats = {StoredMatch::StoredSeat{"Ada", hash_token("a")},
                        StoredMatch::StoredSeat{"Ben", hash_token("b")}};
        MatchRecord first;
        first.match = table.id;
        first.game = "end_game";
        first.server = "test";
        first.first = Seat{0};
        if (settings != MatchSettings{}) first.settings = settings;
        stored.records = {first, SeatRecord{Seat{0}, "Ada"}, SeatRecord{Seat{1}, "Ben"}};
        for (const MemberId member : {kAda, kBen})
            table.roster.disconnect(member);
    }

    void play(Seat seat, const Move& move, std::int64_t at_ms = 0) {
        MatchStep step = table.match.play(seat, move, at_ms);
        stored.records.emplace_back(move_record(step));
        table.commit(std::move(step), at_ms);
    }

    /// A shot of whose turn it is; a game that is over stays so.
    void shoot(Vec2 direction = kSafe) {
        if (!table.match.now().game.over)
            play(table.match.now().legal.seat, Shoot{Stroke{direction, {}}});
    }

    MatchRecord& match_record() { return std::get<MatchRecord>(stored.records.front()); }

    MoveRecord& last_move() { return std::get<MoveRecord>(stored.records.back()); }

    /// What is wrong with the log, "" if nothing.
    [[nodiscard]] std::string fault() const {
        const auto rebuilt = rebuild(stored);
        return rebuilt ? std::string() : rebuilt.error();
    }

    void expect_rebuilt() const {
        const auto rebuilt = rebuild(stored);
        ASSERT_TRUE(rebuilt.ok()) << rebuilt.error();
        EXPECT_EQ(state_of(*rebuilt, 0), state_of(table, 0));
        EXPECT_EQ(rebuilt->match.now(), table.match.now());
    }

    Table table;
    StoredMatch stored;
};

TEST(Rebuild, TableIsAsItsLogLeftIt) {
    Logged logged;
    logged.play(Seat{0}, Place{{end_game::kBaseLineX, 0.1}});
    logged.expect_rebuilt();
    for (int shot = 0; shot < 3; ++shot)
        logged.shoot();
    logged.expect_rebuilt();
    const auto rebuilt = rebuild(logged.stored);
    EXPECT_EQ(rebuilt->roster.seats_of(hash_token("b")), std::vector<Seat>{Seat{1}});
    EXPECT_FALSE(rebuilt->roster.attended());
}

TEST(Rebuild, ConcessionConsentAndTheNextGameAreKept) {
    Logged logged;
    logged.play(Seat{1}, Concede{});
    logged.expect_rebuilt();
    logged.play(Seat{1}, Agree{});
    logged.expect_rebuilt();
    logged.play(Seat{0}, Agree{});
    logged.shoot();
    logged.expect_rebuilt();
}

TEST(Rebuild, TimeOutStandsWhateverTheClockSaysNow) {
    MatchSettings settings;
    settings.shot_clock_s = 30;
    Logged logged(settings);
    logged.table.match.start_clock(1'000'000);
    logged.play(Seat{0}, TimeOut{}, 1'030'000);
    logged.play(Seat{1}, TimeOut{}, 1'060'000);
    std::get<MoveRecord>(logged.stored.records.back()).at_ms = 5;
    const auto rebuilt = rebuild(logged.stored);
    ASSERT_TRUE(rebuilt.ok()) << rebuilt.error();
    EXPECT_EQ(rebuilt->match.now(), logged.table.match.now());
}

TEST(Rebuild, MatchKeepsItsSettings) {
    for (const SolverSpec& solver : poolhall::test::kPlayableSolvers) {
        MatchSettings settings{poolhall::test::pool_settings(solver)};
        settings.race_to = 3;
        settings.breaks = BreakOrder::kWinner;
        Logged logged(settings);
        for (int shot = 0; shot < 3; ++shot)
            logged.shoot();
        logged.expect_rebuilt();
        EXPECT_EQ(rebuild(logged.stored)->match.settings(), settings);
    }
}

TEST(Rebuild, ShotsOfOtherSettingsAreRefused) {
    Logged logged({poolhall::test::pool_settings()});
    logged.shoot();
    logged.match_record().settings.reset();
    EXPECT_NE(logged.fault(), "");
    logged.match_record().settings.emplace().game.solver = SolverSpec{SolverKind::kOverlap, 30};
    EXPECT_NE(logged.fault().find("/solver/kind"), std::string::npos) << logged.fault();
}

TEST(Rebuild, DivergenceIsNamed) {
    Logged logged;
    logged.shoot();
    logged.shoot();
    ++logged.last_move().state_hash;
    EXPECT_NE(logged.fault().find("DIVERGED"), std::string::npos) << logged.fault();
}

TEST(Rebuild, ShotOfAnotherPhysicsIsTakenAsItWasRecorded) {
    Logged logged;
    logged.shoot();
    MoveRecord& record = logged.last_move();
    record.shot->edition = kPhysicsEdition + 1;
    set_xy(record.state.scene.balls[0].state.r, {0.1, 0.2});
    record.state_hash = hash_of(record.state);
    const auto rebuilt = rebuild(logged.stored);
    ASSERT_TRUE(rebuilt.ok()) << rebuilt.error();
    EXPECT_EQ(rebuilt->match.now().game, record.state);
}

TEST(Rebuild, MissingShotIsRefused) {
    Logged logged;
    for (int shot = 0; shot < 3; ++shot)
        logged.shoot();
    logged.stored.records.erase(logged.stored.records.end() - 2);
    EXPECT_NE(logged.fault(), "");
}

TEST(Rebuild, RecordsThatMakeNoMatchAreRefused) {
    Logged logged;
    logged.shoot();
    logged.last_move().seat = Seat{1};
    EXPECT_NE(logged.fault(), "");
    logged.stored.records = {};
    EXPECT_NE(logged.fault(), "");
    logged.stored.records = {SeatRecord{Seat{0}, "Ada"}};
    EXPECT_NE(logged.fault(), "");
    MatchRecord unknown;
    unknown.game = "snooker";
    unknown.first = Seat{0};
    logged.stored.records = {unknown};
    EXPECT_NE(logged.fault().find("snooker"), std::string::npos) << logged.fault();
}

TEST(Rebuild, SeatThatWasLeftIsOpen) {
    Logged logged;
    logged.stored.records.emplace_back(SeatRecord{Seat{1}, ""});
    logged.stored.seats[1] = {};
    const auto rebuilt = rebuild(logged.stored);
    ASSERT_TRUE(rebuilt.ok()) << rebuilt.error();
    EXPECT_EQ(rebuilt->roster.open_seat(), Seat{1});
}

}  // namespace
}  // namespace poolhall::server
