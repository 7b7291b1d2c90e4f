#include "tests/protocol/replay/followed.hpp"
#include "tests/protocol/replay/played_match.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <gtest/gtest.h>

// Logs of version 1.
namespace poolhall::protocol {
namespace {

using namespace poolhall::test;

constexpr std::uint32_t kShots = 30;
constexpr std::uint32_t kTampered = 3;
/// Of the physics: that of all logs of version 1.
constexpr std::uint32_t kEdition = 1;

template <class Change>
std::vector<ReplayRecord> with_shot_changed(std::vector<ReplayRecord> records,
                                            const Change& change) {
    for (ReplayRecord& record : records) {
        auto* shot = std::get_if<ShotRecord>(&record);
        if (shot != nullptr && shot->shot == kTampered) change(*shot);
    }
    return records;
}

/// What is found in shot kTampered if it is changed. All shots but it and the next must be good.
template <class Change>
std::vector<std::string> deviations_after(const Change& change) {
    const auto records = with_shot_changed(played_match_v1("m1", kShots), change);
    std::vector<std::string> found;
    for (const Followed& followed : follow(records, kEdition)) {
        if (followed.subject == "shot 3") {
            found = followed.found.deviations;
        } else if (followed.subject != "shot 4") {
            EXPECT_EQ(first(followed.found.deviations), "nothing") << followed.subject;
        }
    }
    return found;
}

TEST(LogFollowerOfVersion1, FindsAPlayedMatchGood) {
    const auto records = played_match_v1("m1", kShots);
    const auto games = std::count_if(
        records.begin(), records.end(),
        [](const ReplayRecord& record) { return std::holds_alternative<GameRecord>(record); });
    EXPECT_GT(games, 1) << "the match must have a game that ended";
    const auto all = follow(records, kEdition);
    EXPECT_EQ(first(deviations_of(all)), "nothing");
    EXPECT_EQ(first(remarks_of(all)), "nothing");
    EXPECT_EQ(shots_of(all).size(), kShots);
}

TEST(LogFollowerOfVersion1, ComesToTheSamePositionsAsOneOfTheSameMoves) {
    LogFollower older;
    LogFollower newer;
    for (const auto& record : played_match_v1("m1", kShots))
        older.follow(record);
    for (const auto& record : played_match("m1", kShots))
        newer.follow(record);
    EXPECT_EQ(older.match()->moves().size(), newer.match()->moves().size());
    EXPECT_EQ(older.match()->now(), newer.match()->now());
    for (std::size_t count = 0; count <= newer.match()->moves().size(); ++count)
        EXPECT_EQ(older.match()->at(count).game, newer.match()->at(count).game) << count;
}

TEST(LogFollowerOfVersion1, GoesOnWithMoves) {
    for (std::uint32_t shots = 1; shots < 12; ++shots) {
        auto records = played_match_v1("m1", shots);
        const auto newer = played_match("m1", 12);
        records.pop_back();
        std::uint32_t taken = 0;
        for (const ReplayRecord& record : newer) {
            const auto* move = std::get_if<MoveRecord>(&record);
            if (move != nullptr && taken >= shots) records.push_back(record);
            if (move != nullptr && move->shot) ++taken;
        }
        EXPECT_EQ(first(deviations_of(follow(records, kEdition))), "nothing") << shots;
    }
}

TEST(LogFollowerOfVersion1, NamesAWrongFinalHash) {
    const auto found = deviations_after([](ShotRecord& shot) { shot.final_hash ^= 1U; });
    EXPECT_EQ(first(found).substr(0, 5), "hash ");
    EXPECT_TRUE(has(found, "the times of all events agree")) << first(found);
}

TEST(LogFollowerOfVersion1, NamesTheFirstEventThatDiverges) {
    const auto found = deviations_after([](ShotRecord& shot) {
        shot.final_hash ^= 1U;
        shot.event_times.at(1) += 0.25;
    });
    EXPECT_TRUE(has(found, "first at event 2 (ball_")) << first(found);
}

TEST(LogFollowerOfVersion1, NamesAWrongSceneHashKernelDurationAndCount) {
    EXPECT_TRUE(first(deviations_after([](ShotRecord& shot) {
                    shot.scene_hash ^= 1U;
                })).starts_with("scene hash "));
    EXPECT_TRUE(first(deviations_after([](ShotRecord& shot) {
                    shot.kernel = "rails";
                })).starts_with("kernel rails does not cover the scene"));
    EXPECT_TRUE(first(deviations_after([](ShotRecord& shot) {
                    shot.duration += 1;
                })).starts_with("duration "));
    EXPECT_TRUE(first(deviations_after([](ShotRecord& shot) {
                    ++shot.event_count;
                })).starts_with("events "));
}

/// Logs of before there was a kernel for their scenes name another one.
TEST(LogFollowerOfVersion1, TakesEveryKernelThatCoversTheScene) {
    EXPECT_EQ(first(deviations_after([](ShotRecord& shot) { shot.kernel = "everything"; })),
              "nothing");
}

TEST(LogFollowerOfVersion1, NamesAWrongRuling) {
    const auto found =
        deviations_after([](ShotRecord& shot) { shot.ruling.verdict = Verdict::kWon; });
    EXPECT_EQ(first(found).substr(0, 7), "ruling ");
}

/// Where the first shot stands that another one of its game follows.
std::size_t first_of_two(const std::vector<ReplayRecord>& records) {
    std::size_t i = 0;
    while (!std::holds_alternative<ShotRecord>(records.at(i)) ||
           !std::holds_alternative<ShotRecord>(records.at(i + 1)))
        ++i;
    return i;
}

/// Another shot of the same seat, good in itself: only the next can tell.
TEST(LogFollowerOfVersion1, NamesTheShotThatDoesNotFollowFromTheOneBefore) {
    auto records = played_match_v1("m1", kShots);
    const std::size_t index = first_of_two(records);
    auto& shot = std::get<ShotRecord>(records.at(index));
    LogFollower follower;
    for (std::size_t i = 0; i < index; ++i)
        follower.follow(records[i]);
    Match played = *follower.match();
    if (played.now().legal.place)
        played.commit(played.play(shot.seat, Place{xy(shot.scene.balls[0].state.r)}, 0), 0);
    MatchStep step;
    for (double y = 0.3; !step.shot() || step.after.game.over; y += 0.01)
        step = played.play(shot.seat, Shoot{Stroke{{-1, y}, {}}}, 0);
    const ShotTrace& trace = step.shot()->simulated.trace;
    shot.scene = step.shot()->simulated.scene;
    shot.scene_hash = hash_of(shot.scene);
    shot.final_hash = trace.hash;
    shot.duration = trace.duration;
    shot.event_count = static_cast<std::uint32_t>(trace.events.size());
    shot.event_times.clear();
    shot.ruling = *step.ruling();
    const std::string next = "shot " + std::to_string(shot.shot + 1);
    EXPECT_TRUE(first(deviations_of(follow(records, kEdition)))
                    .starts_with(next + ": the scene does not follow from the shots before it: "
                                        "/balls/0/r"))
        << first(deviations_of(follow(records, kEdition)));
}

TEST(LogFollowerOfVersion1, NamesAShotOutOfTurnOrWithAStrikeThatIsNotAllowed) {
    EXPECT_EQ(first(deviations_after([](ShotRecord& shot) {
                  shot.seat = opponent(shot.seat);
              })).substr(0, 12),
              "shot by seat");
    const auto faster = deviations_after([](ShotRecord& shot) { shot.scene.strike->speed *= 2; });
    EXPECT_TRUE(has(faster, "the strike is not one that the rules give")) << first(faster);
    const auto other_ball =
        deviations_after([](ShotRecord& shot) { shot.scene.strike->ball = BallIndex{1}; });
    EXPECT_TRUE(has(other_ball, "the strike is not on the cue ball")) << first(other_ball);
}

TEST(LogFollowerOfVersion1, NamesACueBallThatWasMovedAfterTheFirstShot) {
    const auto found = deviations_after([](ShotRecord& shot) {
        shot.scene.balls[0].state.r.y += 0.001;
        shot.scene_hash = hash_of(shot.scene);
    });
    EXPECT_TRUE(has(found, "/balls/0/r/1")) << first(found);
}

TEST(LogFollowerOfVersion1, NamesACueBallThatBeganOffTheBaseLine) {
    auto records = played_match_v1("m1", 1);
    std::get<ShotRecord>(records.at(4)).scene.balls[0].state.r.x += 0.1;
    EXPECT_TRUE(has(deviations_of(follow(records, kEdition)),
                    "the cue ball was put where the rules do not allow it (out_of_region)"));
}

TEST(LogFollowerOfVersion1, ChecksTheShotsOfAGameItDoesNotKnow) {
    auto records = played_match_v1("m1", kShots);
    std::get<MatchRecord>(records.front()).game = "snooker";
    const auto all = follow(records, kEdition);
    EXPECT_EQ(first(deviations_of(all)), "nothing");
    EXPECT_EQ(shots_of(all).size(), kShots);
}

TEST(LogFollowerOfVersion1, FindsAMatchOfEverySolverGood) {
    for (const SolverSpec& solver : kPlayableSolvers) {
        const auto all = follow(played_match_v1("m1", kShots, pool_settings(solver)), kEdition);
        EXPECT_EQ(first(deviations_of(all)), "nothing");
        EXPECT_EQ(shots_of(all).size(), kShots);
    }
}

TEST(LogFollowerOfVersion1, NamesAShotThatWasNotPlayedWithTheMatchsSettings) {
    auto records = played_match_v1("m1", 1, pool_settings());
    std::get<MatchRecord>(records.front()).settings->game.effects->sliding->mu = 0.25;
    EXPECT_TRUE(has(deviations_of(follow(records, kEdition)), "/effects/sliding/mu"));
}

TEST(LogFollowerOfVersion1, NamesNumbersAndGamesThatDoNotFollow) {
    auto records = played_match_v1("m1", 2);
    records.erase(records.begin() + 3);
    EXPECT_TRUE(
        has(deviations_of(follow(records, kEdition)), "shot 1: no game was begun before it"));
    records = played_match_v1("m1", kShots);
    const std::size_t index = first_of_two(records);
    const std::uint32_t left_out = std::get<ShotRecord>(records.at(index)).shot;
    records.erase(records.begin() + static_cast<std::ptrdiff_t>(index));
    EXPECT_TRUE(has(deviations_of(follow(records, kEdition)),
                    "shot " + std::to_string(left_out + 1) + ": number " +
                        std::to_string(left_out + 1) + " expected " + std::to_string(left_out)));
    records = played_match_v1("m1", 1);
    records.insert(records.begin() + 4, GameRecord{2, Seat{1}});
    EXPECT_TRUE(has(deviations_of(follow(records, kEdition)),
                    "record 5 (game): it does not follow from the game before"));
}

/// Version 1 is of edition 1, and says nothing of where a shot left the balls but in the next one.
TEST(LogFollowerOfVersion1, AShotOfAnotherEditionIsNoDeviation) {
    constexpr std::uint32_t kLaterEdition = 2;
    const auto records = played_match_v1("m1", kShots);
    EXPECT_EQ(first(remarks_of(follow(records, kLaterEdition))), "nothing") << "the same results";
    const auto otherwise = with_shot_changed(records, [](ShotRecord& shot) {
        shot.final_hash ^= 1U;
        shot.event_times.at(1) += 0.25;
    });
    const auto all = follow(otherwise, kLaterEdition);
    EXPECT_EQ(first(deviations_of(all)), "nothing");
    EXPECT_EQ(first(remarks_of(all)).substr(0, 68),
              "shot 3: played by edition 1 of the physics: first at event 2 (ball_b");
}

TEST(LogFollowerOfVersion1, TheNextShotShowsWhereAnotherEditionLeftTheBalls) {
    auto records = played_match_v1("m1", kShots);
    const std::size_t index = first_of_two(records);
    auto& before = std::get<ShotRecord>(records.at(index));
    auto& after = std::get<ShotRecord>(records.at(index + 1));
    const std::string next = "shot " + std::to_string(after.shot);
    records.resize(index + 2);
    before.final_hash ^= 1U;
    after.scene.balls[1].state.r.y += 0.0032;
    after.scene_hash = hash_of(after.scene);
    const auto all = follow(records, 2);
    EXPECT_EQ(first(deviations_of(all)), "nothing");
    EXPECT_TRUE(has(remarks_of(all),
                    next + ": of the shot before: final states up to 3.2 mm apart (ball 8)"))
        << first(remarks_of(all));
}

}  // namespace
}  // namespace poolhall::protocol
