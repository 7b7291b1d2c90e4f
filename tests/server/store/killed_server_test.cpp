#include "protocol/archive/database.hpp"
#include "tests/server/store/store_fixture.hpp"

#include <SQLiteCpp/Database.h>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <map>
#include <sys/wait.h>
#include <unistd.h>

// What a server that is killed in a bad moment leaves behind, made by hand: the moments are short.
namespace poolhall::server {
namespace {

using namespace poolhall::test;
namespace fs = std::filesystem;

constexpr std::size_t kLogHeaderBytes = 32;
constexpr std::size_t kIndexBytes = 32'768;

/// The three files of a store.
struct Files {
    std::string database;
    std::string log;
    std::string index;
};

class KilledServer : public testing::Test {
  protected:
    /// m1 stands in the database; m2 in the log.
    void SetUp() override {
        const TemporaryFolder live;
        open_and_store(live.path(), "m1").reset();
        ended_ = files_of(live.path());
        const auto store = open_and_store(live.path(), "m2");
        killed_ = files_of(live.path());
    }

    void leave(const Files& files) const {
        write_file(file(), files.database);
        write_file(file("-wal"), files.log);
        write_file(file("-shm"), files.index);
    }

    /// Reads both matches without a wait, and changes nothing; then a server finds them, too.
    void expect_matches(const std::string& what, bool second) const {
        const std::string first_text = replay_file(played_match("m1", 3));
        const std::string second_text = second ? replay_file(played_match("m2", 3)) : "unknown";
        const auto before = contents();
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(exported(folder_.path(), "m1"), first_text) << what;
        EXPECT_EQ(exported(folder_.path(), "m2"), second_text) << what;
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(8)) << what;
        EXPECT_EQ(contents(), before) << what;
        EXPECT_EQ(open_failure(folder_.path()), "ok") << what;
        EXPECT_EQ(exported(folder_.path(), "m1"), first_text) << what;
        EXPECT_EQ(exported(folder_.path(), "m2"), second_text) << what;
    }

    [[nodiscard]] fs::path file(const char* suffix = "") const {
        return folder_.path() / (std::string("poolhall.sqlite") + suffix);
    }

    [[nodiscard]] const Files& ended() const { return ended_; }

    [[nodiscard]] const Files& killed() const { return killed_; }

  private:
    static std::unique_ptr<ReplayStore> open_and_store(const fs::path& folder,
                                                       const std::string& id) {
        auto store = open_store(folder);
        store_match(*store, id, "BCDFGH", played_match(id, 3));
        return store;
    }

    /// Of a live store they are those that a kill would leave.
    static Files files_of(const fs::path& folder) {
        const auto read = [&](const char* suffix) {
            return read_file(folder / (std::string("poolhall.sqlite") + suffix));
        };
        return {read(""), read("-wal"), read("-shm")};
    }

    [[nodiscard]] std::map<fs::path, std::string> contents() const {
        std::map<fs::path, std::string> found;
        for (const auto& entry : fs::directory_iterator(folder_.path()))
            found[entry.path()] = read_file(entry.path());
        return found;
    }

    TemporaryFolder folder_;
    Files ended_;
    Files killed_;
};

/// Good, cut as by the next opener, empty, of no store.
std::vector<std::string> indexes(const std::string& good) {
    std::string torn = good;
    torn.replace(40, 8, "torn now");  // the two copies of its header differ
    return {good,
            good.substr(0, 3),
            "",
            torn,
            std::string(kIndexBytes, 'x'),
            std::string(kIndexBytes, '\0')};
}

TEST_F(KilledServer, ALogIsReadWhateverItsIndexIsLike) {
    for (const std::string& index : indexes(killed().index)) {
        leave({killed().database, killed().log, index});
        expect_matches("index of " + std::to_string(index.size()) + " bytes", true);
    }
}

TEST_F(KilledServer, ALogOfAHeaderOnlyIsAsNone) {
    for (const std::string& index : indexes(killed().index)) {
        leave({ended().database, killed().log.substr(0, kLogHeaderBytes), index});
        expect_matches("index of " + std::to_string(index.size()) + " bytes", false);
    }
}

TEST_F(KilledServer, ALogThatWasBegunOrIsNoneIsAsNone) {
    for (const std::string& log :
         {killed().log.substr(0, 1), killed().log.substr(0, kLogHeaderBytes - 1),
          killed().log.substr(0, kLogHeaderBytes + 1), killed().log.substr(0, 1000),
          std::string(5000, '\0'), std::string(5000, 'x')}) {
        leave({ended().database, log, killed().index});
        expect_matches("log of " + std::to_string(log.size()) + " bytes", false);
    }
}

TEST_F(KilledServer, AReaderRemovesNoLogOfAnEmptyDatabase) {
    leave({"", killed().log, killed().index});
    EXPECT_EQ(exported(file().parent_path(), "m1"), file().string() + " is empty");
    EXPECT_EQ(read_file(file("-wal")), killed().log);
}

/// A process that holds the index as SQLite does, as long as it is there.
class IndexHolder {
  public:
    IndexHolder(const fs::path& index, int kind) {
        std::array<int, 2> ready{};
        if (pipe(ready.data()) != 0) return;
        child_ = fork();
        if (child_ == 0) {
            struct flock lock {};

            lock.l_type = static_cast<short>(kind);
            lock.l_start = 128;  // SQLite's "dead man's switch"
            lock.l_len = 1;
            const int file = open(index.c_str(), O_RDWR | O_CLOEXEC);
            const bool held = fcntl(file, F_SETLK, &lock) == 0 && write(ready[1], "r", 1) == 1;
            while (held)
                pause();
            _exit(1);
        }
        close(ready[1]);
        char byte = 0;
        EXPECT_EQ(read(ready[0], &byte, 1), 1);
        close(ready[0]);
    }

    ~IndexHolder() {
        kill(child_, SIGKILL);
        waitpid(child_, nullptr, 0);
    }

    IndexHolder(const IndexHolder&) = delete;
    IndexHolder& operator=(const IndexHolder&) = delete;

  private:
    pid_t child_ = 0;
};

TEST_F(KilledServer, AnIndexThatSomebodyHoldsAndNobodyMendsIsNotWaitedFor) {
    const std::string first = replay_file(played_match("m1", 3));
    for (const int kind : {F_RDLCK, F_WRLCK}) {
        for (const std::string& index : indexes(killed().index)) {
            if (index == killed().index) continue;  // what could not be told from a good one
            leave({killed().database, killed().log, index});
            const IndexHolder holder(file("-shm"), kind);
            const auto start = std::chrono::steady_clock::now();
            EXPECT_EQ(exported(file().parent_path(), "m1"), first) << index.size();
            EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(8));
            EXPECT_EQ(read_file(file("-shm")), index);
        }
    }
}

}  // namespace
}  // namespace poolhall::server
