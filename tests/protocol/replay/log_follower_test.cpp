#include "protocol/replay/log_follower.hpp"

#include "shared/game/end_game.hpp"
#include "tests/protocol/replay/followed.hpp"
#include "tests/protocol/replay/played_match.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace poolhall::protocol {
namespace {

using namespace poolhall::test;

constexpr std::uint32_t kShots = 30;
constexpr std::uint32_t kTampered = 3;
const std::string kSubject = "shot 3";

template <class Change>
std::vector<ReplayRecord> with_shot_changed(const Change& change) {
    auto records = played_match("m1", kShots);
    for (ReplayRecord& record : records) {
        auto* move = std::get_if<MoveRecord>(&record);
        if (move != nullptr && move->shot && move->shot->shot == kTampered) change(*move);
    }
    return records;
}

/// What is found in shot kTampered if it is changed. All records but it and the next must be good.
template <class Change>
std::vector<std::string> deviations_after(const Change& change) {
    std::vector<std::string> found;
    bool is_next = false;
    for (const Followed& followed : follow(with_shot_changed(change))) {
        if (followed.subject == kSubject) {
            found = followed.found.deviations;
        } else if (!is_next) {
            EXPECT_EQ(first(followed.found.deviations), "nothing") << followed.subject;
        }
        is_next = followed.subject == kSubject;
    }
    return found;
}

MoveRecord& move_at(std::vector<ReplayRecord>& records, std::size_t index) {
    return std::get<MoveRecord>(records.at(index));
}

/// A match as its moves are logged, one by one.
struct Log {
    explicit Log(const MatchSettings& settings = {}) : match({&kEndGameRules, Seat{0}, settings}) {
        MatchRecord first = match_record("m1");
        first.settings = settings;
        records.emplace_back(first);
        match.start_clock(0);
    }

    void play(Seat seat, const Move& move, std::int64_t at_ms = 0) {
        MatchStep step = match.play(seat, move, at_ms);
        records.emplace_back(move_record(step));
        match.commit(std::move(step), at_ms);
    }

    Match match;
    std::vector<ReplayRecord> records;
};

TEST(LogFollower, FindsAPlayedMatchGood) {
    const auto all = follow(played_match("m1", kShots));
    EXPECT_EQ(first(deviations_of(all)), "nothing");
    EXPECT_EQ(first(remarks_of(all)), "nothing");
    EXPECT_EQ(shots_of(all).size(), kShots);
}

TEST(LogFollower, FindsAMatchOfEverySolverGood) {
    for (const SolverSpec& solver : kPlayableSolvers) {
        const auto all = follow(played_match("m1", kShots, {pool_settings(solver)}));
        EXPECT_EQ(first(deviations_of(all)), "nothing");
        EXPECT_EQ(shots_of(all).size(), kShots);
    }
}

TEST(LogFollower, EndsWhereTheMatchStood) {
    MatchSettings settings;
    settings.shot_clock_s = 30;
    settings.race_to = 2;
    settings.breaks = BreakOrder::kLoser;
    Log log(settings);
    log.play(Seat{0}, Place{{end_game::kBaseLineX, 0.1}});
    log.play(Seat{0}, TimeOut{}, 30'000);
    log.play(Seat{1}, Shoot{Stroke{{-1, 0.02}, {}}}, 40'000);
    log.play(Seat{1}, Concede{}, 50'000);
    log.play(Seat{1}, Agree{}, 60'000);
    log.play(Seat{0}, Agree{}, 70'000);
    log.play(Seat{1}, Concede{}, 80'000);
    LogFollower follower;
    for (const ReplayRecord& record : log.records)
        EXPECT_EQ(first(follower.follow(record).found.deviations), "nothing");
    EXPECT_EQ(follower.match()->now(), log.match.now());
    EXPECT_EQ(follower.match()->moves(), log.match.moves());
    EXPECT_EQ(follower.match()->now().winner, Seat{0});
}

TEST(LogFollower, AChangeOfSeatBeginsItsScoreAndConsentAnew) {
    Log log;
    log.play(Seat{1}, Concede{});
    log.play(Seat{0}, Agree{});
    log.records.emplace_back(SeatRecord{Seat{0}, "Zoe"});
    LogFollower follower;
    for (const ReplayRecord& record : log.records)
        follower.follow(record);
    EXPECT_EQ(follower.match()->now().wins[0], 0U);
    EXPECT_FALSE(follower.match()->now().consents[0]);
    EXPECT_EQ(follower.names()[0], "Zoe");
}

/// How long a match stood still is not logged, and a clock may be set back.
TEST(LogFollower, ATimeOutStandsWhateverTheTimesSay) {
    MatchSettings settings;
    settings.shot_clock_s = 30;
    Log log(settings);
    log.play(Seat{0}, TimeOut{}, 30'000);
    move_at(log.records, 1).at_ms = 5;
    EXPECT_EQ(first(deviations_of(follow(log.records))), "nothing");
    std::get<MatchRecord>(log.records[0]).settings->shot_clock_s.reset();
    EXPECT_EQ(first(deviations_of(follow(log.records))),
              "record 2 (time_out): the match has no shot clock");
}

TEST(LogFollower, NamesAWrongHashAndTheFirstEventThatDiverges) {
    const auto hash = deviations_after([](MoveRecord& move) { move.shot->trace ^= 1U; });
    EXPECT_EQ(first(hash).substr(0, 5), "hash ");
    EXPECT_TRUE(has(hash, "the times of all events agree")) << first(hash);
    const auto event = deviations_after([](MoveRecord& move) {
        move.shot->trace ^= 1U;
        move.shot->event_times.at(1) += 0.25;
    });
    EXPECT_TRUE(has(event, "first at event 2 (ball_")) << first(event);
}

TEST(LogFollower, NamesAWrongStateAndGoesOnFromIt) {
    const auto found = deviations_after([](MoveRecord& move) {
        move.state.scene.balls[1].state.r.y += 1e-9;
        move.state_hash = hash_of(move.state);
    });
    EXPECT_TRUE(first(found).starts_with("state /scene/balls/1/r/1 ")) << first(found);
}

TEST(LogFollower, NamesAStateThatIsNotThatOfItsHash) {
    const auto found = deviations_after([](MoveRecord& move) { move.state_hash ^= 1U; });
    EXPECT_EQ(first(found).substr(0, 11), "state hash ");
}

TEST(LogFollower, NamesAWrongRulingNumberDurationAndCount) {
    EXPECT_TRUE(first(deviations_after([](MoveRecord& move) {
                    move.ruling->verdict = Verdict::kWon;
                })).starts_with("ruling "));
    EXPECT_TRUE(first(deviations_after([](MoveRecord& move) {
                    move.ruling.reset();
                })).ends_with("expected none"));
    EXPECT_TRUE(first(deviations_after([](MoveRecord& move) {
                    move.shot->duration += 1;
                })).starts_with("duration "));
    EXPECT_TRUE(first(deviations_after([](MoveRecord& move) {
                    ++move.shot->event_count;
                })).starts_with("events "));
    auto records = played_match("m1", 2);
    std::erase_if(records, [](const ReplayRecord& record) {
        const auto* move = std::get_if<MoveRecord>(&record);
        return move != nullptr && move->shot && move->shot->shot == 1;
    });
    EXPECT_TRUE(has(deviations_of(follow(records)), "shot 2: number 2 expected 1"));
}

TEST(LogFollower, NamesMovesThatTheSeatMightNotMake) {
    const auto other_seat =
        deviations_after([](MoveRecord& move) { move.seat = opponent(move.seat); });
    EXPECT_EQ(first(other_seat), "it was not that seat's turn");
    const auto faster =
        deviations_after([](MoveRecord& move) { std::get<Shoot>(move.move).strike.speed = 20; });
    EXPECT_EQ(first(faster), "the rules do not allow it (out_of_bounds at /strike/speed)");

    auto records = played_match("m1", 1);
    std::get<Place>(move_at(records, 3).move).position.x = 0.1;
    EXPECT_EQ(first(deviations_of(follow(records))),
              "record 4 (place): the rules do not allow it (out_of_region at /position)");

    Log log;
    log.play(Seat{0}, Concede{});
    log.play(Seat{0}, Agree{});
    std::swap(log.records[1], log.records[2]);
    EXPECT_EQ(first(deviations_of(follow(log.records))),
              "record 2 (agree): the game was not over before it");
}

TEST(LogFollower, NamesAMoveThatLeavesOpenWhatWasPlayed) {
    const auto found =
        deviations_after([](MoveRecord& move) { std::get<Shoot>(move.move).strike.speed.reset(); });
    EXPECT_EQ(first(found).substr(0, 19), "move /strike/speed ");
}

TEST(LogFollower, NamesSettingsThatNoServerTakes) {
    auto records = played_match("m1", 2, {pool_settings()});
    std::get<MatchRecord>(records.front()).settings->game.solver =
        SolverSpec{SolverKind::kOverlap, 30};
    const auto found = deviations_of(follow(records));
    EXPECT_EQ(first(found).substr(0, 62),
              "record 1 (match): the settings cannot be played: /solver/kind ")
        << first(found);
    EXPECT_FALSE(has(found, "shot 2")) << "it goes on from the records";
}

// ---- editions

TEST(LogFollower, AShotOfAnotherEditionWithTheSameResultIsGood) {
    for (const std::uint32_t edition : {0U, kPhysicsEdition + 1, 4294967295U}) {
        const auto all =
            follow(with_shot_changed([&](MoveRecord& move) { move.shot->edition = edition; }));
        EXPECT_EQ(first(deviations_of(all)), "nothing");
        EXPECT_EQ(first(remarks_of(all)), "nothing");
    }
}

TEST(LogFollower, AShotOfAnotherEditionMayEndElsewhereAndTheMatchGoesOnFromThere) {
    for (const std::uint32_t edition : {0U, kPhysicsEdition + 1}) {
        auto records = with_shot_changed([&](MoveRecord& move) {
            move.shot->edition = edition;
            move.shot->trace ^= 1U;
            move.state.scene.balls[1].state.r.y += 0.0032;
            move.state_hash ^= 1U;  // of states, too, another edition may have another
        });
        const auto tampered = std::find_if(records.begin(), records.end(), [](const auto& record) {
            const auto* move = std::get_if<MoveRecord>(&record);
            return move != nullptr && move->shot && move->shot->shot == kTampered;
        });
        records.erase(tampered + 1, records.end());
        LogFollower follower;
        std::vector<Followed> all;
        for (const auto& record : records)
            all.push_back(follower.follow(record));
        EXPECT_EQ(first(deviations_of(all)), "nothing");
        EXPECT_EQ(first(remarks_of(all)),
                  "shot 3: played by edition " + std::to_string(edition) +
                      " of the physics: final states up to 3.2 mm apart (ball 8), the times of all "
                      "events agree");
        EXPECT_FALSE(all.back().shot->as_recorded);
        const GameState& recorded = move_at(records, records.size() - 1).state;
        EXPECT_EQ(follower.match()->now().game, recorded);
        EXPECT_EQ(follower.match()->at(follower.match()->moves().size()).game, recorded);
    }
}

TEST(LogFollower, SaysWhenAnotherEditionLeftTheSameStatesOrOtherBalls) {
    const auto same = with_shot_changed([](MoveRecord& move) {
        move.shot->edition = 0;
        move.shot->trace ^= 1U;
    });
    EXPECT_TRUE(has(remarks_of(follow(same)),
                    "shot 3: played by edition 0 of the physics: same "
                    "final states"));
    const auto fewer = with_shot_changed([](MoveRecord& move) {
        move.shot->edition = 0;
        move.state.scene.balls.pop_back();
        move.ruling->verdict = Verdict::kWon;
    });
    const auto found = remarks_of(follow(fewer));
    EXPECT_TRUE(has(found, "ball 8 is on the table only here")) << first(found);
    EXPECT_TRUE(has(found, "ruling turn_passes")) << first(found);
}

TEST(LogFollower, NoEditionExcusesAnotherTableOrAMoveOutOfTurn) {
    const auto table = deviations_after([](MoveRecord& move) {
        move.shot->edition = 0;
        move.state.scene.table.width = 1;
    });
    EXPECT_EQ(first(table).substr(0, 18), "state /table/width") << first(table);
    const auto seat = deviations_after([](MoveRecord& move) {
        move.shot->edition = 0;
        move.seat = opponent(move.seat);
    });
    EXPECT_EQ(first(seat), "it was not that seat's turn");
}

TEST(LogFollower, SaysThatAKernelOrSolverDoesNotExistAnyMore) {
    const auto records = with_shot_changed([](MoveRecord& move) {
        move.shot->kernel = "warp\x1B";
        move.shot->solver = "leapfrog";
    });
    const auto all = follow(records);
    EXPECT_EQ(first(deviations_of(all)), "nothing");
    EXPECT_TRUE(has(remarks_of(all), "there is no kernel warp? here: simulated by drag_rails_"));
    EXPECT_TRUE(has(remarks_of(all), "there is no solver leapfrog here: simulated by euler"));
    EXPECT_EQ(first(deviations_after([](MoveRecord& move) { move.shot->solver = "event"; })),
              "solver euler expected event");
}

}  // namespace
}  // namespace poolhall::protocol
