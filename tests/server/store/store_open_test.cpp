#include "protocol/archive/database.hpp"
#include "tests/server/store/store_fixture.hpp"

#include <SQLiteCpp/Database.h>
#include <map>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace poolhall::server {
namespace {

using namespace poolhall::test;

/// Runs `body` in a process of its own without the rights of root; its result.
template <class Body>
std::string as_ordinary_user(const Body& body, std::size_t limit = 1000) {
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
    std::string result(limit, '\0');
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

    /// Name and owner of all that is in the folder.
    [[nodiscard]] static std::map<std::string, uid_t> files(const std::filesystem::path& in) {
        std::map<std::string, uid_t> found;
        for (const auto& entry : std::filesystem::directory_iterator(in)) {
            struct stat status {};

            EXPECT_EQ(::stat(entry.path().c_str(), &status), 0);
            found[entry.path().filename()] = status.st_uid;
        }
        return found;
    }

    [[nodiscard]] std::map<std::string, uid_t> files() const { return files(folder()); }

    [[nodiscard]] std::filesystem::path file() const { return folder() / "poolhall.sqlite"; }

    [[nodiscard]] std::string file_of(const char* suffix) const { return file().string() + suffix; }

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
              file().string() + " cannot be written: Permission denied; it belongs to user " +
                  std::to_string(getuid()));
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

TEST_F(StoreOpen, AReaderOfAnotherUserWhoMayWriteTheFolderLeavesNothingBehind) {
    fill();
    allow(kWriteFolder, kWriteFile);
    const auto before = files();
    const std::string file = as_ordinary_user([this] { return exported(folder(), "m1"); });
    EXPECT_EQ(file.substr(0, 7), "{\"sum\":");
    EXPECT_EQ(files(), before);
    EXPECT_EQ(open_failure(folder()), "ok");
}

/// A server's store in a process of its own: what one process has opened, its children share.
class StoreProcess {
  public:
    explicit StoreProcess(const std::filesystem::path& folder) {
        std::array<int, 2> ready{};
        std::array<int, 2> stay{};
        if (pipe(ready.data()) != 0 || pipe(stay.data()) != 0) return;
        child_ = fork();
        if (child_ == 0) {
            close(stay[1]);
            auto store = open_store(folder);
            store_match(*store, "m1", "BCDFGH", played_match("m1", 3));
            char byte = 0;
            const bool told = write(ready[1], "r", 1) == 1 && read(stay[0], &byte, 1) == 0;
            store.reset();
            _exit(told ? 0 : 1);
        }
        close(ready[1]);
        close(stay[0]);
        stay_ = stay[1];
        char byte = 0;
        EXPECT_EQ(read(ready[0], &byte, 1), 1);
        close(ready[0]);
    }

    ~StoreProcess() {
        close(stay_);
        waitpid(child_, nullptr, 0);
    }

    StoreProcess(const StoreProcess&) = delete;
    StoreProcess& operator=(const StoreProcess&) = delete;

  private:
    pid_t child_ = 0;
    int stay_ = -1;
};

TEST_F(StoreOpen, AReaderOfAnotherUserBesideALiveServerSeesTheNewestAndLeavesNothingBehind) {
    {
        const StoreProcess server(folder());
        allow(kWriteFolder, kReadFile);
        const auto before = files();
        EXPECT_GE(before.size(), 4U);
        const std::string file = as_ordinary_user([this] { return exported(folder(), "m1"); });
        EXPECT_EQ(file.substr(0, 7), "{\"sum\":");
        EXPECT_EQ(files(), before);
        std::filesystem::permissions(file_of("-shm"), std::filesystem::perms::owner_all);
        EXPECT_EQ(as_ordinary_user([this] { return exported(folder(), "m1"); }),
                  file_of("-shm") + " cannot be read: Permission denied; it belongs to user " +
                      std::to_string(getuid()));
    }
    EXPECT_EQ(files().size(), 2U) << "the server left more than the database and its lock";
}

/// The folder as a server leaves it that is killed with all that it stored in the log.
void copy_live(const std::filesystem::path& live, const std::filesystem::path& to, bool index) {
    std::filesystem::create_directory(to);
    for (const char* suffix : {"", "-wal", "-shm"}) {
        if (suffix == std::string("-shm") && !index) continue;
        const std::string name = std::string("poolhall.sqlite") + suffix;
        std::filesystem::copy_file(live / name, to / name);
    }
}

TEST_F(StoreOpen, AReaderOfWhatAKilledServerLeftSeesTheNewestAndLeavesNothingBehind) {
    const TemporaryFolder live;
    const StoreProcess server(live.path());
    const std::string whole = replay_file(played_match("m1", 3));
    for (const bool index : {true, false}) {
        const auto killed = folder() / (index ? "killed" : "copied without index");
        copy_live(live.path(), killed, index);
        for (const auto rights : {kWriteFolder, kReadFolder}) {
            std::filesystem::permissions(folder(), kWriteFolder);
            std::filesystem::permissions(killed, rights);
            const auto before = files(killed);
            EXPECT_EQ(as_ordinary_user([&] { return exported(killed, "m1"); }, whole.size()),
                      whole);
            EXPECT_EQ(exported(killed, "m1"), whole);
            EXPECT_EQ(files(killed), before);
        }
        std::filesystem::permissions(killed, kWriteFolder);
        EXPECT_EQ(open_failure(killed), "ok");
    }
}

TEST_F(StoreOpen, AReaderSeesWhatAServerStoresThatBeganAfterIt) {
    fill();
    const auto archive = protocol::ReplayArchive::open(folder());
    ASSERT_TRUE(archive);
    ASSERT_EQ(archive->list(10)->size(), 1U);
    {
        const auto store = open_store(folder());
        store_match(*store, "m2", "BCDFGH", played_match("m2", 1));
        EXPECT_EQ(archive->list(10)->size(), 2U);
        store_match(*store, "m3", "BCDFGH", played_match("m3", 1));
        EXPECT_EQ(archive->list(10)->size(), 3U);
    }
    EXPECT_EQ(archive->list(10)->size(), 3U);
    open_store(folder()).reset();
    EXPECT_EQ(archive->list(10)->size(), 3U);
}

TEST_F(StoreOpen, AServerNamesTheFileOfAnotherUserThatIsInItsWay) {
    fill();
    for (const char* name : {"poolhall.sqlite-wal", "poolhall.sqlite-shm", "poolhall.lock"}) {
        allow(kWriteFolder, kWriteFile);
        const bool is_new = !std::filesystem::exists(folder() / name);
        if (is_new) write_file(folder() / name, "");
        std::filesystem::permissions(folder() / name, kReadFile);
        const std::string failure = as_ordinary_user([this] { return open_failure(folder()); });
        EXPECT_NE(failure.find((folder() / name).string()), std::string::npos) << failure;
        EXPECT_NE(failure.find("Permission denied"), std::string::npos) << failure;
        if (is_new) std::filesystem::remove(folder() / name);
    }
}

TEST_F(StoreOpen, AReaderSaysThatThereIsNoStore) {
    EXPECT_EQ(exported(folder(), "m1"), "there is no replay store at " + file().string());
    write_file(file(), "");
    EXPECT_EQ(exported(folder(), "m1"), file().string() + " is empty");
}

}  // namespace
}  // namespace poolhall::server
