#include "protocol/archive/database.hpp"
#include "tests/server/store/store_fixture.hpp"

#include <SQLiteCpp/Database.h>
#include <sys/wait.h>
#include <unistd.h>

namespace poolhall::server {
namespace {

using namespace poolhall::test;

/// Runs `body` in a process of its own without the rights of root; its result.
template <class Body>
std::string as_ordinary_user(const Body& body) {
    constexpr uid_t kNobody = 65534;
    std::array<int, 2> pipe_ends{};
    if (pipe(pipe_ends.data()) != 0) return "no pipe";
    const pid_t child = fork();
    if (child == 0) {
        const bool root = getuid() == 0;
        const std::string result =
            root && setuid(kNobody) != 0 ? "cannot become an ordinary user" : body();
        _exit(write(pipe_ends[1], result.data(), result.size()) < 0 ? 1 : 0);
    }
    close(pipe_ends[1]);
    std::string result(1000, '\0');
    const auto size = read(pipe_ends[0], result.data(), result.size());
    close(pipe_ends[0]);
    waitpid(child, nullptr, 0);
    result.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
    return result;
}

constexpr auto kReadFolder = static_cast<std::filesystem::perms>(0555);
constexpr auto kWriteFolder = static_cast<std::filesystem::perms>(0777);
constexpr auto kReadFile = static_cast<std::filesystem::perms>(0444);
constexpr auto kWriteFile = static_cast<std::filesystem::perms>(0666);

class StoreOpen : public testing::Test {
  protected:
    void TearDown() override { std::filesystem::permissions(folder(), kWriteFolder); }

    void fill() const {
        store_match(*open_store(folder_.path()), "m1", "BCDFGH", played_match("m1", 3));
    }

    [[nodiscard]] std::filesystem::path folder() const { return folder_.path(); }

    [[nodiscard]] std::filesystem::path file() const { return folder() / "poolhall.sqlite"; }

    void allow(std::filesystem::perms folder_rights, std::filesystem::perms file_rights) const {
        std::filesystem::permissions(folder(), folder_rights);
        for (const auto& entry : std::filesystem::directory_iterator(folder())) {
            std::filesystem::permissions(entry.path(), file_rights);
        }
    }

  private:
    TemporaryFolder folder_;
};

TEST_F(StoreOpen, CreatesTheFolderAndTheTables) {
    EXPECT_EQ(open_failure(folder() / "a" / "b"), "ok");
    EXPECT_TRUE(std::filesystem::exists(folder() / "a" / "b" / "poolhall.sqlite"));
}

TEST_F(StoreOpen, ASecondServerIsRefused) {
    const auto first = open_store(folder());
    EXPECT_EQ(open_failure(folder()), folder().string() + " is in use by another server");
}

TEST_F(StoreOpen, TheFolderIsFreeAgainOnceClosed) {
    open_store(folder()).reset();
    EXPECT_EQ(open_failure(folder()), "ok");
}

TEST_F(StoreOpen, AFileInPlaceOfTheFolderIsRefused) {
    write_file(folder() / "x", "");
    EXPECT_EQ(open_failure(folder() / "x").substr(0, 24), "cannot create the folder");
}

TEST_F(StoreOpen, AFolderThatCannotBeWrittenIsRefused) {
    allow(kReadFolder, kReadFile);
    EXPECT_EQ(as_ordinary_user([this] { return open_failure(folder()); }),
              "cannot write to " + folder().string() + ": Permission denied");
}

TEST_F(StoreOpen, ADatabaseThatCannotBeWrittenIsRefused) {
    fill();
    allow(kWriteFolder, kWriteFile);
    std::filesystem::permissions(file(), kReadFile);
    EXPECT_EQ(as_ordinary_user([this] { return open_failure(folder()); }),
              file().string() + " cannot be written");
}

TEST_F(StoreOpen, WhatIsNoDatabaseIsRefusedAndLeftAlone) {
    const std::string text = "Dear diary, this is a text that is longer than a header of SQLite. " +
                             std::string(4096, '.');
    write_file(file(), text);
    EXPECT_EQ(open_failure(folder()), file().string() + " is not a database");
    EXPECT_EQ(read_file(file()), text);
}

TEST_F(StoreOpen, ADatabaseOfAnotherProgramIsRefused) {
    SQLite::Database(file().string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
        .exec("CREATE TABLE t (x)");
    EXPECT_EQ(open_failure(folder()), file().string() + " is not a Poolhall replay store");
}

TEST_F(StoreOpen, ANewerVersionIsRefused) {
    fill();
    SQLite::Database(file().string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 3");
    EXPECT_EQ(open_failure(folder()),
              file().string() + " was written by a newer version of Poolhall");
    EXPECT_EQ(exported(folder(), "m1"),
              file().string() + " was written by a newer version of Poolhall");
}

TEST_F(StoreOpen, ADamagedPageIsFound) {
    fill();
    std::string bytes = read_file(file());
    constexpr std::size_t kPage = 4096;
    std::size_t refused = 0;
    for (std::size_t page = 1; page * kPage < bytes.size(); ++page) {
        std::string damaged = bytes;
        damaged.replace(page * kPage, 8, 8, '\xFF');
        write_file(file(), damaged);
        refused += open_failure(folder()).starts_with(file().string() + " is damaged") ? 1U : 0U;
    }
    EXPECT_EQ(refused, bytes.size() / kPage - 1);
}

TEST_F(StoreOpen, ATruncatedDatabaseIsFound) {
    fill();
    const std::string bytes = read_file(file());
    write_file(file(), bytes.substr(0, bytes.size() / 2));
    EXPECT_EQ(open_failure(folder()).substr(0, file().string().size() + 11),
              file().string() + " is damaged");
}

TEST_F(StoreOpen, ARecordThatWasAlteredIsNamedAndTheOthersAreResumed) {
    {
        const auto store = open_store(folder());
        for (const std::string id : {"m1", "m2"}) {
            auto records = played_match(id, 2);
            records.pop_back();
            store_match(*store, id, id, records);
        }
    }
    SQLite::Database(file().string(), SQLite::OPEN_READWRITE)
        .exec("UPDATE records SET body = replace(body, 'Bob', 'Rob') WHERE match = 1");
    const auto open = open_store(folder())->load_open_matches();
    ASSERT_TRUE(open);
    ASSERT_EQ(open->matches.size(), 1U);
    EXPECT_EQ(open->matches[0].id, "m2");
    ASSERT_EQ(open->damaged.size(), 1U);
    EXPECT_EQ(open->damaged[0].substr(0, 36), "match m1 cannot be resumed: line 3, ");
}

TEST_F(StoreOpen, AReaderNeedsNoRightToWrite) {
    fill();
    allow(kReadFolder, kReadFile);
    EXPECT_EQ(as_ordinary_user([this] { return exported(folder(), "m1"); }).substr(0, 7),
              "{\"sum\":");
}

TEST_F(StoreOpen, AReaderSaysThatThereIsNoStore) {
    EXPECT_EQ(exported(folder(), "m1"), "there is no replay store at " + file().string());
    write_file(file(), "");
    EXPECT_EQ(exported(folder(), "m1"), file().string() + " is empty");
}

}  // namespace
}  // namespace poolhall::server
