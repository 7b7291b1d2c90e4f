#include "protocol/replay/reader.hpp"
#include "tests/server/store/full_disk.hpp"
#include "tests/server/store/store_fixture.hpp"

#include <algorithm>
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace poolhall::server {
namespace {

using namespace poolhall::test;
using protocol::MoveRecord;

constexpr std::uint32_t kEndless = 1'000'000;

/// Stores record after record and writes the number of each to `report` once it is durable.
[[noreturn]] void store_until_killed(const std::filesystem::path& folder, int report) {
    const auto opened = ReplayStore::open({folder, kEndless});
    if (!opened) _exit(1);
    ReplayStore& store = **opened;
    store.submit(CreateMatchJob{"BCDFGH", match_record("m1")}, [](const JobFailure&) {});
    MoveRecord move = some_move(0);
    for (std::uint32_t n = 1; n < kEndless; ++n) {
        move.at_ms = n;
        store.submit(AppendMoveJob{"m1", move}, [report, n](const JobFailure& failure) {
            if (failure || write(report, &n, sizeof n) != sizeof n) _exit(1);
        });
        // A few jobs a transaction, so that the kill falls between transactions as well as into
        // them.
        if (n % 4 == 0) usleep(100);
    }
    _exit(1);
}

/// Kills a storing process after a while; the number of the last record that it was told to be
/// durable.
std::uint32_t last_acknowledged_of_killed(const std::filesystem::path& folder, useconds_t life_us) {
    std::array<int, 2> pipe_ends{};
    if (pipe(pipe_ends.data()) != 0) return 0;
    const pid_t child = fork();
    if (child == 0) store_until_killed(folder, pipe_ends[1]);
    close(pipe_ends[1]);
    std::uint32_t n = 0;
    std::uint32_t last = 0;
    while (last == 0 && read(pipe_ends[0], &n, sizeof n) == sizeof n)
        last = n;
    usleep(life_us);
    kill(child, SIGKILL);
    while (read(pipe_ends[0], &n, sizeof n) == sizeof n)
        last = n;
    close(pipe_ends[0]);
    waitpid(child, nullptr, 0);
    return last;
}

TEST(StoreCrash, AllThatWasAcknowledgedIsThereAfterAKill) {
    for (useconds_t life_us = 1000; life_us < 60'000; life_us += 7000) {
        const TemporaryFolder folder;
        const std::uint32_t acknowledged = last_acknowledged_of_killed(folder.path(), life_us);
        ASSERT_GT(acknowledged, 0U);
        const auto open = open_store(folder.path())->load_open_matches();
        ASSERT_TRUE(open) << open.error().reason;
        ASSERT_TRUE(open->damaged.empty()) << open->damaged[0];
        const auto& records = open->matches.at(0).records;
        ASSERT_GE(records.size(), acknowledged + 1);
        for (std::uint32_t n = 1; n < records.size(); ++n)
            EXPECT_EQ(std::get<MoveRecord>(records[n]).at_ms, n);
    }
}

TEST(StoreCrash, AReaderCanReadWhatAKilledServerLeft) {
    const TemporaryFolder folder;
    const std::uint32_t acknowledged = last_acknowledged_of_killed(folder.path(), 20'000);
    const std::string file = exported(folder.path(), "m1");
    EXPECT_GT(std::count(file.begin(), file.end(), '\n'), acknowledged);
}

TEST(StoreFull, AFullDiskFailsTheJobsUntilThereIsRoomAgain) {
    const TemporaryFolder folder;
    const auto store = open_store(folder.path());
    auto records = played_match("m1", 60);
    records.pop_back();  // its end, which is small and may still find room
    std::vector<protocol::ReplayRecord> stored;
    std::size_t failed = 0;
    {
        const FullDisk full(128 * 1024);
        for (const auto& record : records) {
            const std::string answer = done(*store, job_for("m1", "BCDFGH", record));
            if (answer == "ok") {
                stored.push_back(record);
            } else {
                ++failed;
                EXPECT_NE(answer.find("poolhall.sqlite"), std::string::npos) << answer;
            }
        }
    }
    ASSERT_GT(failed, 0U);
    ASSERT_GT(stored.size(), 5U);
    EXPECT_EQ(exported(folder.path(), "m1"), replay_file(stored));
    ASSERT_EQ(done(*store, job_for("m1", "BCDFGH", records[4])), "ok");
    stored.push_back(records[4]);
    EXPECT_EQ(exported(folder.path(), "m1"), replay_file(stored));
}

TEST(StoreFull, AFullDiskIsFoundAtTheStart) {
    const TemporaryFolder folder;
    const FullDisk full(0);
    const std::string failure = open_failure(folder.path());
    EXPECT_NE(failure.find((folder.path() / "poolhall.sqlite").string()), std::string::npos)
        << failure;
}

TEST(StoreFull, AFullDiskIsFoundAtTheStartOfAnOldStoreToo) {
    const TemporaryFolder folder;
    store_match(*open_store(folder.path()), "m1", "BCDFGH", played_match("m1", 1));
    const FullDisk full(0);
    const std::string failure = open_failure(folder.path());
    EXPECT_NE(failure.find((folder.path() / "poolhall.sqlite").string()), std::string::npos)
        << failure;
}

}  // namespace
}  // namespace poolhall::server
