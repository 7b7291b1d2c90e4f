#include "server/store/replay_store.hpp"

#include "protocol/replay/reader.hpp"
#include "tests/server/store/store_fixture.hpp"

#include <atomic>
#include <thread>

namespace poolhall::server {
namespace {

using namespace poolhall::test;
using protocol::EndRecord;
using protocol::MatchRecord;
using protocol::MoveRecord;
using protocol::ReplayRecord;
using protocol::SeatRecord;

constexpr std::uint32_t kShots = 5;

TEST(ReplayStore, ExportsByteForByteWhatWasStored) {
    const TemporaryFolder folder;
    const auto records = played_match("m1", kShots);
    const auto store = open_store(folder.path());
    store_match(*store, "m1", "BCDFGH", records);
    EXPECT_EQ(exported(folder.path(), "m1"), replay_file(records));
}

TEST(ReplayStore, ExportsTheSameAfterItWasClosed) {
    const TemporaryFolder folder;
    const auto records = played_match("m1", kShots);
    store_match(*open_store(folder.path()), "m1", "BCDFGH", records);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "poolhall.sqlite-wal"));
    EXPECT_EQ(exported(folder.path(), "m1"), replay_file(records));
}

TEST(ReplayStore, UnknownIdsAreUnknownWhateverTheyLookLike) {
    const TemporaryFolder folder;
    const auto store = open_store(folder.path());
    store_match(*store, "m1", "BCDFGH", played_match("m1", 1));
    for (const std::string id :
         {"", "m2", "M1", "../m1", "../../etc/passwd", "%", "m1'--", "m1 "}) {
        EXPECT_EQ(exported(folder.path(), id), "unknown") << id;
    }
    EXPECT_EQ(exported(folder.path(), std::string("m1\0", 3)), "unknown");
    EXPECT_EQ(exported(folder.path(), std::string(1 << 20, 'a')), "unknown");
}

TEST(ReplayStore, JobsThatDoNotFitAreRefusedAndLeaveNothing) {
    const TemporaryFolder folder;
    const auto store = open_store(folder.path());
    ASSERT_EQ(done(*store, CreateMatchJob{"BCDFGH", match_record("m1")}), "ok");
    const std::string before = exported(folder.path(), "m1");
    EXPECT_EQ(done(*store, CreateMatchJob{"ZZZZZZ", match_record("m1")}),
              "match m1 or its code exists already");
    EXPECT_EQ(done(*store, CreateMatchJob{"BCDFGH", match_record("m2")}),
              "match m2 or its code exists already");
    EXPECT_EQ(done(*store, CreateMatchJob{"ZZZZZZ", match_record("../m")}),
              "a match id must be 1 to 64 letters, digits, _ or -");
    EXPECT_EQ(done(*store, AppendMoveJob{"m2", some_move(1)}), "there is no open match m2");
    EXPECT_EQ(exported(folder.path(), "m1"), before);
    EXPECT_EQ(exported(folder.path(), "m2"), "unknown");
}

TEST(ReplayStore, AClosedMatchTakesNothingMoreAndFreesItsCode) {
    const TemporaryFolder folder;
    const auto store = open_store(folder.path());
    ASSERT_EQ(done(*store, CreateMatchJob{"BCDFGH", match_record("m1")}), "ok");
    ASSERT_EQ(done(*store, CloseMatchJob{"m1", {"over", 2000}}), "ok");
    EXPECT_EQ(done(*store, AppendMoveJob{"m1", some_move(1)}), "there is no open match m1");
    EXPECT_EQ(done(*store, CloseMatchJob{"m1", {"over", 2000}}), "there is no open match m1");
    EXPECT_EQ(done(*store, CreateMatchJob{"BCDFGH", match_record("m2")}), "ok");
}

TEST(ReplayStore, ARestartedServerFindsTheOpenMatches) {
    const TemporaryFolder folder;
    auto records = played_match("m1", kShots);
    records.pop_back();  // not ended
    records.emplace_back(SeatRecord{Seat{1}, ""});
    {
        const auto store = open_store(folder.path());
        store_match(*store, "m1", "BCDFGH", records);
        store_match(*store, "m2", "JKLMNP", played_match("m2", 1));
    }
    const auto open = open_store(folder.path())->load_open_matches();
    ASSERT_TRUE(open) << open.error().reason;
    ASSERT_EQ(open->matches.size(), 1U);
    const StoredMatch& match = open->matches[0];
    EXPECT_EQ(match.id, "m1");
    EXPECT_EQ(match.code, "BCDFGH");
    EXPECT_EQ(match.seats[0].name, "Ann");
    EXPECT_EQ(match.seats[0].token_hash, "hash of Ann");
    EXPECT_EQ(match.seats[1].name, "");
    EXPECT_EQ(match.seats[1].token_hash, "");
    EXPECT_EQ(replay_file(match.records), replay_file(records));
    EXPECT_TRUE(open->damaged.empty());
}

TEST(ReplayStore, ListsMatchesNewestFirstPageByPage) {
    const TemporaryFolder folder;
    const auto store = open_store(folder.path());
    for (const std::string id : {"m1", "m2", "m3"}) {
        ASSERT_EQ(done(*store, CreateMatchJob{id, match_record(id)}), "ok");
        ASSERT_EQ(done(*store, SetSeatJob{id, {Seat{0}, "Ann of " + id}, "x"}), "ok");
    }
    ASSERT_EQ(done(*store, SetSeatJob{"m2", {Seat{0}, ""}, ""}), "ok");
    ASSERT_EQ(done(*store, CloseMatchJob{"m2", {"over", 2000}}), "ok");
    const auto archive = store->open_archive();
    const auto page = archive->list(2);
    ASSERT_EQ(page->size(), 2U);
    EXPECT_EQ(page->at(0).id, "m3");
    EXPECT_EQ(page->at(0).closed_ms, std::nullopt);
    EXPECT_EQ(page->at(1).id, "m2");
    EXPECT_EQ(page->at(1).names[0], "Ann of m2");
    EXPECT_EQ(page->at(1).names[1], "");
    EXPECT_EQ(page->at(1).closed_ms, 2000);
    const auto rest = archive->list(2, page->at(1).position);
    ASSERT_EQ(rest->size(), 1U);
    EXPECT_EQ(rest->at(0).id, "m1");
    EXPECT_EQ(rest->at(0).created_ms, match_record("m1").created_ms);
}

TEST(ReplayStore, CountsTheShotsOfEachMatch) {
    const TemporaryFolder folder;
    const auto store = open_store(folder.path());
    store_match(*store, "m1", "BCDFGH", played_match("m1", kShots));
    EXPECT_EQ(store->open_archive()->list(1)->at(0).shots, kShots);
}

TEST(ReplayStore, CountsGamesAndThoseWonByWhoSatDownLast) {
    const TemporaryFolder folder;
    const auto store = open_store(folder.path());
    const auto records = played_match("m1", 30);
    std::uint32_t games = 0;
    PerSeat<std::uint32_t> wins{};
    for (const ReplayRecord& record : records) {
        const auto* move = std::get_if<MoveRecord>(&record);
        if (move == nullptr || !move->ruling || !move->ruling->winner) continue;
        ++games;
        ++wins[move->ruling->winner->value];
    }
    ASSERT_GT(wins[0], 0U);
    ASSERT_GT(wins[1], 0U);
    store_match(*store, "m1", "BCDFGH", {records.begin(), records.end() - 1});
    const auto archive = store->open_archive();
    EXPECT_EQ(archive->list(1)->at(0).games, games);
    EXPECT_EQ(archive->list(1)->at(0).wins, wins);
    ASSERT_EQ(done(*store, SetSeatJob{"m1", {Seat{1}, ""}, ""}), "ok");
    EXPECT_EQ(archive->list(1)->at(0).wins, wins) << "they are still Bob's";
    ASSERT_EQ(done(*store, SetSeatJob{"m1", {Seat{1}, "Zoe"}, "x"}), "ok");
    EXPECT_EQ(archive->list(1)->at(0).wins, (PerSeat<std::uint32_t>{wins[0], 0}));
    EXPECT_EQ(archive->list(1)->at(0).games, games);
}

TEST(ReplayStore, KeepsTokensOutOfWhatItExports) {
    const TemporaryFolder folder;
    const auto store = open_store(folder.path());
    store_match(*store, "m1", "BCDFGH", played_match("m1", 1));
    const std::string text = exported(folder.path(), "m1");
    EXPECT_EQ(text.find("hash of"), std::string::npos);
    EXPECT_EQ(text.find("BCDFGH"), std::string::npos);
}

TEST(ReplayStore, ManyThreadsShareCommitsAndNoNumberIsMissing) {
    constexpr int kThreads = 8;
    constexpr std::uint32_t kJobs = 200;
    const TemporaryFolder folder;
    const auto store = open_store(folder.path());
    std::atomic<std::uint32_t> stored = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < kThreads; ++i) {
        threads.emplace_back([&, id = "m" + std::to_string(i)] {
            const auto count = [&](const JobFailure& failure) { stored += failure ? 0 : 1; };
            store->submit(CreateMatchJob{id, match_record(id)}, count);
            for (std::uint32_t n = 2; n <= kJobs; ++n)
                store->submit(AppendMoveJob{id, some_move(n)}, count);
        });
    }
    for (std::thread& thread : threads)
        thread.join();
    const auto open = [&] {
        EXPECT_EQ(done(*store, CreateMatchJob{"last", match_record("last")}), "ok");
        return store->load_open_matches();
    }();
    EXPECT_EQ(stored, kThreads * kJobs);
    ASSERT_EQ(open->matches.size(), kThreads + 1U);
    for (int i = 0; i < kThreads; ++i) {
        const auto& records = open->matches[static_cast<std::size_t>(i)].records;
        ASSERT_EQ(records.size(), kJobs);
        for (std::uint32_t n = 2; n <= kJobs; ++n)
            EXPECT_EQ(std::get<MoveRecord>(records[n - 1]).at_ms, n);
    }
}

TEST(ReplayStore, WhatIsQueuedIsDoneBeforeItCloses) {
    constexpr std::uint32_t kJobs = 500;
    const TemporaryFolder folder;
    std::atomic<std::uint32_t> stored = 0;
    {
        const auto store = open_store(folder.path());
        ASSERT_EQ(done(*store, CreateMatchJob{"BCDFGH", match_record("m1")}), "ok");
        for (std::uint32_t n = 1; n <= kJobs; ++n) {
            store->submit(AppendMoveJob{"m1", some_move(n)},
                          [&](const JobFailure& failure) { stored += failure ? 0 : 1; });
        }
    }
    EXPECT_EQ(stored, kJobs);
    EXPECT_EQ(open_store(folder.path())->load_open_matches()->matches.at(0).records.size(),
              kJobs + 1);
}

TEST(ReplayStore, AFullQueueRefusesAtOnce) {
    const TemporaryFolder folder;
    auto opened = ReplayStore::open({folder.path(), 2});
    ASSERT_TRUE(opened);
    ReplayStore& store = **opened;
    std::promise<void> go_on;
    std::promise<void> writer_waits;
    store.submit(CreateMatchJob{"BCDFGH", match_record("m1")}, [&](const JobFailure&) {
        writer_waits.set_value();
        go_on.get_future().wait();
    });
    writer_waits.get_future().wait();
    std::atomic<int> stored = 0;
    for (int i = 0; i < 2; ++i) {
        store.submit(AppendMoveJob{"m1", some_move(1)},
                     [&](const JobFailure& failure) { stored += failure ? 0 : 1; });
    }
    EXPECT_EQ(store.backlog(), 2U);
    EXPECT_EQ(done(store, AppendMoveJob{"m1", some_move(1)}),
              "the replay store cannot keep up: 2 jobs wait");
    go_on.set_value();
    opened->reset();
    EXPECT_EQ(stored, 2);
}

TEST(ReplayStore, ReadersSeeWhatIsStoredWhileItIsOpen) {
    const TemporaryFolder folder;
    const auto store = open_store(folder.path());
    const auto archive = store->open_archive();
    EXPECT_TRUE(archive->list(10)->empty());
    ASSERT_EQ(done(*store, CreateMatchJob{"BCDFGH", match_record("m1")}), "ok");
    EXPECT_EQ(archive->list(10)->size(), 1U);
}

}  // namespace
}  // namespace poolhall::server
