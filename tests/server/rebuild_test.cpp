#include "server/room/rebuild.hpp"

#include "shared/game/end_game.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using namespace protocol;

/// The log of a match with `shots` shots, the first with the cue ball moved, and the match itself.
struct Logged {
    explicit Logged(std::uint32_t shots, const GameSettings& settings = {})
        : match({"0123456789abcdef", "BCDFGH", &kEndGameRules, Seat{0}, settings}) {
        stored.id = match.id();
        stored.code = match.code();
        stored.seats = {StoredMatch::StoredSeat{"Ada", hash_token("a")},
                        StoredMatch::StoredSeat{"Ben", hash_token("b")}};
        stored.records = {MatchRecord{match.id(), "end_game", "test", 0}, GameRecord{1, Seat{0}},
                          SeatRecord{Seat{0}, "Ada"}, SeatRecord{Seat{1}, "Ben"}};
        if (settings != GameSettings{}) match_record().settings = settings;
        for (const Seat seat : kSeats)
            match.take_seat(
                seat, {stored.seats[seat.value].name, stored.seats[seat.value].token_hash, {}});
        match.place_cue_ball({end_game::kBaseLineX, 0.1});
        for (std::uint32_t shot = 1; shot <= shots; ++shot)
            play(shot);
    }

    void play(std::uint32_t shot) {
        ShotOutcome outcome = match.rules().play(match.game(), {{-1, 0.02}});
        ShotRecord record = shot_record(outcome);
        record.shot = shot;
        record.game_number = 1;
        record.seat = match.game().turn;
        stored.records.emplace_back(record);
        match.start_shot(std::move(outcome), {});
        match.finish_shot();
    }

    MatchRecord& match_record() { return std::get<MatchRecord>(stored.records.front()); }

    ShotRecord& last_shot() { return std::get<ShotRecord>(stored.records.back()); }

    Match match;
    StoredMatch stored;
};

TEST(Rebuild, MatchIsAsItsLogLeftIt) {
    Logged logged(3);
    const auto rebuilt = rebuild(logged.stored);
    ASSERT_TRUE(rebuilt.ok()) << rebuilt.error();
    EXPECT_EQ(rebuilt->table(), logged.match.table());
    EXPECT_EQ(rebuilt->seats_of(hash_token("b")), std::vector<Seat>{Seat{1}});
    EXPECT_FALSE(rebuilt->table().seats[0].connected);
}

TEST(Rebuild, MatchKeepsItsSettings) {
    for (const SolverSpec& solver : poolhall::test::kPlayableSolvers) {
        const GameSettings settings = poolhall::test::pool_settings(solver);
        Logged logged(3, settings);
        auto rebuilt = rebuild(logged.stored);
        ASSERT_TRUE(rebuilt.ok()) << rebuilt.error();
        EXPECT_EQ(rebuilt->table(), logged.match.table());
        rebuilt->start_next_game();
        EXPECT_EQ(rebuilt->game(), new_game(kEndGameRules, Seat{1}, settings));
    }
}

TEST(Rebuild, ShotsOfOtherSettingsAreRefused) {
    Logged logged(2, poolhall::test::pool_settings());
    logged.match_record().settings.reset();
    const auto without = rebuild(logged.stored);
    ASSERT_FALSE(without.ok());
    EXPECT_NE(without.error().find("shot 1"), std::string::npos) << without.error();
    logged.match_record().settings.emplace().solver = SolverSpec{SolverKind::kOverlap, 30};
    const auto unfit = rebuild(logged.stored);
    ASSERT_FALSE(unfit.ok());
    EXPECT_NE(unfit.error().find("/solver/kind"), std::string::npos) << unfit.error();
}

TEST(Rebuild, DivergenceIsNamed) {
    Logged logged(2);
    ++logged.last_shot().final_hash;
    const auto rebuilt = rebuild(logged.stored);
    ASSERT_FALSE(rebuilt.ok());
    EXPECT_NE(rebuilt.error().find("shot 2 DIVERGED"), std::string::npos) << rebuilt.error();
}

TEST(Rebuild, ShotFromAnotherSceneIsRefused) {
    Logged logged(2);
    ++logged.last_shot().scene_hash;
    EXPECT_FALSE(rebuild(logged.stored).ok());
}

TEST(Rebuild, MissingShotIsRefused) {
    Logged logged(3);
    logged.stored.records.erase(logged.stored.records.end() - 2);
    EXPECT_FALSE(rebuild(logged.stored).ok());
}

TEST(Rebuild, RecordsThatMakeNoMatchAreRefused) {
    Logged logged(1);
    logged.last_shot().scene.balls.clear();
    EXPECT_FALSE(rebuild(logged.stored).ok());
    logged.last_shot().scene = Scene{};
    logged.last_shot().scene.strike.reset();
    EXPECT_FALSE(rebuild(logged.stored).ok());
    logged.stored.records = {};
    EXPECT_FALSE(rebuild(logged.stored).ok());
    logged.stored.records = {MatchRecord{"x", "snooker", "test", 0}};
    EXPECT_FALSE(rebuild(logged.stored).ok());
    logged.stored.records = {SeatRecord{Seat{0}, "Ada"}};
    EXPECT_FALSE(rebuild(logged.stored).ok());
}

TEST(Rebuild, SeatThatWasLeftIsOpen) {
    Logged logged(1);
    logged.stored.records.emplace_back(SeatRecord{Seat{1}, ""});
    logged.stored.seats[1] = {};
    const auto rebuilt = rebuild(logged.stored);
    ASSERT_TRUE(rebuilt.ok()) << rebuilt.error();
    EXPECT_EQ(rebuilt->open_seat(), Seat{1});
}

}  // namespace
}  // namespace poolhall::server
