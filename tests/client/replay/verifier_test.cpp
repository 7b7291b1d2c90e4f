#include "client/replay/verifier.hpp"

#include "shared/game/end_game.hpp"
#include "tests/protocol/replay/played_match.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

using protocol::GameRecord;
using protocol::MatchRecord;
using protocol::ReplayRecord;
using protocol::ShotRecord;

constexpr std::uint32_t kShots = 30;
constexpr std::uint32_t kTampered = 3;

std::vector<ShotReport> verify(const std::vector<ReplayRecord>& records) {
    Verifier verifier;
    std::vector<ShotReport> reports;
    for (const ReplayRecord& record : records) {
        if (auto report = verifier.follow(record)) reports.push_back(*std::move(report));
    }
    return reports;
}

/// What is found in shot kTampered if it is changed. All shots but it and the next must be good.
template <class Change>
std::vector<std::string> divergences_after(const Change& change) {
    auto records = test::played_match("m1", kShots);
    for (ReplayRecord& record : records) {
        auto* shot = std::get_if<ShotRecord>(&record);
        if (shot != nullptr && shot->shot == kTampered) change(*shot);
    }
    std::vector<std::string> found;
    for (const ShotReport& report : verify(records)) {
        if (report.shot == kTampered) {
            found = report.divergences;
        } else if (report.shot != kTampered + 1) {
            EXPECT_TRUE(report.divergences.empty())
                << report.shot << ": " << report.divergences.front();
        }
    }
    return found;
}

std::string first(const std::vector<std::string>& found) {
    return found.empty() ? "nothing" : found.front();
}

TEST(Verifier, FindsAPlayedMatchGood) {
    const auto records = test::played_match("m1", kShots);
    const auto games = std::count_if(
        records.begin(), records.end(),
        [](const ReplayRecord& record) { return std::holds_alternative<GameRecord>(record); });
    EXPECT_GT(games, 1) << "the match must have a game that ended";
    const auto reports = verify(records);
    ASSERT_EQ(reports.size(), kShots);
    for (const ShotReport& report : reports)
        EXPECT_EQ(first(report.divergences), "nothing") << report.shot;
}

TEST(Verifier, NamesAWrongFinalHash) {
    const auto found = divergences_after([](ShotRecord& shot) { shot.final_hash ^= 1U; });
    EXPECT_EQ(first(found).substr(0, 5), "hash ");
    EXPECT_NE(first(found).find("the times of all events agree"), std::string::npos)
        << first(found);
}

TEST(Verifier, NamesTheFirstEventThatDiverges) {
    const auto found = divergences_after([](ShotRecord& shot) {
        shot.final_hash ^= 1U;
        shot.event_times.at(1) += 0.25;
    });
    EXPECT_NE(first(found).find("first at event 2 (ball_"), std::string::npos) << first(found);
}

TEST(Verifier, NamesAWrongSceneHashKernelDurationAndCount) {
    EXPECT_EQ(
        first(divergences_after([](ShotRecord& shot) { shot.scene_hash ^= 1U; })).substr(0, 11),
        "scene hash ");
    for (const char* kernel : {"other", "rails"}) {
        EXPECT_EQ(
            first(divergences_after([&](ShotRecord& shot) { shot.kernel = kernel; })).substr(0, 7),
            "kernel ");
    }
    EXPECT_EQ(first(divergences_after([](ShotRecord& shot) { shot.duration += 1; })).substr(0, 9),
              "duration ");
    EXPECT_EQ(first(divergences_after([](ShotRecord& shot) { ++shot.event_count; })).substr(0, 7),
              "events ");
}

/// Logs of before there was a kernel for their scenes name another one.
TEST(Verifier, TakesEveryKernelThatCoversTheScene) {
    EXPECT_EQ(first(divergences_after([](ShotRecord& shot) { shot.kernel = "everything"; })),
              "nothing");
}

TEST(Verifier, NamesAWrongRuling) {
    const auto found =
        divergences_after([](ShotRecord& shot) { shot.ruling.verdict = Verdict::kWon; });
    EXPECT_EQ(first(found).substr(0, 7), "ruling ");
}

/// Changes the direction of the strike and all that follows from it within the record: only the
/// next shot can tell.
TEST(Verifier, NamesTheShotThatDoesNotFollowFromTheOneBefore) {
    auto records = test::played_match("m1", kTampered + 1);
    for (ReplayRecord& record : records) {
        auto* shot = std::get_if<ShotRecord>(&record);
        if (shot == nullptr || shot->shot != kTampered) continue;
        GameState state;
        state.scene = shot->scene;
        state.scene.strike.reset();
        state.turn = shot->seat;
        state.shots = 1;
        ShotRecord other = protocol::shot_record(kEndGameRules.play(state, {{-1, 0.3}}));
        other.shot = shot->shot;
        other.game_number = shot->game_number;
        *shot = other;
    }
    const auto reports = verify(records);
    EXPECT_EQ(first(reports.at(kTampered - 1).divergences), "nothing");
    EXPECT_EQ(first(reports.at(kTampered).divergences).substr(0, 62),
              "the scene does not follow from the shots before it: /balls/0/r");
}

TEST(Verifier, NamesAShotOutOfTurnOrWithAStrikeThatIsNotAllowed) {
    EXPECT_EQ(first(divergences_after([](ShotRecord& shot) {
                  shot.seat = opponent(shot.seat);
              })).substr(0, 12),
              "shot by seat");
    const auto faster = divergences_after([](ShotRecord& shot) { shot.scene.strike->speed *= 2; });
    EXPECT_EQ(faster.back(), "the strike is not one that the rules give");
    const auto other_ball =
        divergences_after([](ShotRecord& shot) { shot.scene.strike->ball = BallIndex{1}; });
    EXPECT_NE(std::find(other_ball.begin(), other_ball.end(), "the strike is not on the cue ball"),
              other_ball.end());
}

TEST(Verifier, NamesACueBallThatWasMovedAfterTheFirstShot) {
    const auto found = divergences_after([](ShotRecord& shot) {
        shot.scene.balls[0].state.r.y += 0.001;
        shot.scene_hash = hash_of(shot.scene);
    });
    EXPECT_NE(found.at(1).find("/balls/0/r/1"), std::string::npos) << found[1];
}

TEST(Verifier, NamesACueBallThatBeganOffTheBaseLine) {
    auto records = test::played_match("m1", 1);
    std::get<ShotRecord>(records.at(4)).scene.balls[0].state.r.x += 0.1;
    const auto reports = verify(records);
    const auto& found = reports.at(0).divergences;
    EXPECT_NE(std::find(found.begin(), found.end(),
                        "the cue ball was put where the rules do not allow it (out_of_place)"),
              found.end());
}

TEST(Verifier, ChecksTheShotsOfAGameItDoesNotKnow) {
    auto records = test::played_match("m1", kShots);
    std::get<MatchRecord>(records.front()).game = "snooker";
    for (const ShotReport& report : verify(records))
        EXPECT_EQ(first(report.divergences), "nothing");
}

TEST(Verifier, FindsAMatchOfEverySolverGood) {
    for (const SolverSpec& solver : test::kPlayableSolvers) {
        const auto records = test::played_match("m1", kShots, test::pool_settings(solver));
        const auto reports = verify(records);
        ASSERT_EQ(reports.size(), kShots);
        for (const ShotReport& report : reports)
            EXPECT_EQ(first(report.divergences), "nothing") << report.shot;
    }
}

TEST(Verifier, NamesAShotThatWasNotPlayedWithTheMatchsSettings) {
    auto records = test::played_match("m1", 1, test::pool_settings());
    std::get<MatchRecord>(records.front()).settings->effects->sliding->mu = 0.25;
    const auto reports = verify(records);
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_NE(first(reports[0].divergences).find("/effects/sliding/mu"), std::string::npos)
        << first(reports[0].divergences);
}

TEST(Verifier, NamesSettingsThatNoServerTakesOnce) {
    auto records = test::played_match("m1", 2, test::pool_settings());
    std::get<MatchRecord>(records.front()).settings->solver = SolverSpec{SolverKind::kOverlap, 30};
    const auto reports = verify(records);
    ASSERT_EQ(reports.size(), 2U);
    EXPECT_EQ(first(reports[0].divergences).substr(0, 53),
              "the match's settings cannot be played: /solver/kind m");
    EXPECT_NE(first(reports[1].divergences).substr(0, 20), "the match's settings");
}

TEST(Verifier, AShotBeforeAnyGameIsNamed) {
    auto records = test::played_match("m1", 1);
    records.erase(records.begin() + 3);
    const auto reports = verify(records);
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_EQ(reports[0].divergences.back(), "no game was begun before it");
}

}  // namespace
}  // namespace poolhall::client
