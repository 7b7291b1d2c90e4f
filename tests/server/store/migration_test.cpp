#include "protocol/archive/database.hpp"
#include "tests/server/store/full_disk.hpp"
#include "tests/server/store/store_fixture.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <csignal>
#include <map>
#include <sys/wait.h>
#include <unistd.h>

// Stores of version 1, as a server of that time wrote one (tests/golden/replay_v1).
namespace poolhall::server {
namespace {

using namespace poolhall::test;
namespace fs = std::filesystem;

const fs::path kSamples = fs::path(POOLHALL_SOURCE_DIR) / "tests/golden/replay_v1";
const std::map<std::string, std::string> kMatches{
    {"games", "e4f624b65a67c363"},        {"open", "cd5b5c449a9adf57"},
    {"settings", "eed6a8689175c32a"},     {"open_settings", "2863346bdbd43125"},
    {"open_names", "37b760c61d1b7ffa"},   {"open_over", "66af7695fd8e2603"},
    {"open_waiting", "4404dceb320cfcb9"}, {"odd_names", "72fa19e705986b7c"},
};

class Migration : public testing::Test {
  protected:
    void SetUp() override {
        fs::copy_file(kSamples / "poolhall.sqlite", file());
        fs::permissions(file(), fs::perms::owner_read | fs::perms::owner_write);
    }

    [[nodiscard]] fs::path folder() const { return folder_.path(); }

    [[nodiscard]] fs::path file() const { return folder() / "poolhall.sqlite"; }

    [[nodiscard]] fs::path copy(const std::string& number = "") const {
        return file().string() + ".v1" + number;
    }

    /// PRAGMA user_version of a database; 0 if there is none.
    [[nodiscard]] static int version_of(const fs::path& path) {
        if (!fs::exists(path)) return 0;
        SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
        EXPECT_EQ(database.execAndGet("PRAGMA integrity_check").getString(), "ok");
        return database.execAndGet("PRAGMA user_version").getInt();
    }

    void expect_exports_as_they_were() const {
        for (const auto& [name, id] : kMatches)
            EXPECT_EQ(exported(folder(), id), read_file(kSamples / (name + ".jsonl"))) << name;
    }

    [[nodiscard]] std::vector<protocol::ReplaySummary> listed() const {
        const auto archive = protocol::ReplayArchive::open(folder());
        if (!archive) ADD_FAILURE() << archive.error().reason;
        return archive ? *archive->list(100) : std::vector<protocol::ReplaySummary>();
    }

  private:
    TemporaryFolder folder_;
};

TEST_F(Migration, AReaderNeedsNone) {
    const std::string before = read_file(file());
    expect_exports_as_they_were();
    EXPECT_EQ(listed().size(), kMatches.size());
    EXPECT_EQ(read_file(file()), before);
    EXPECT_FALSE(fs::exists(copy()));
}

TEST_F(Migration, AServerKeepsEveryByteOfTheRecordsAndACopy) {
    open_store(folder()).reset();
    EXPECT_EQ(version_of(file()), protocol::kDatabaseVersion);
    expect_exports_as_they_were();
    EXPECT_EQ(version_of(copy()), 1);
    EXPECT_EQ(fs::status(copy()).permissions(), fs::status(file()).permissions());
    fs::rename(copy(), file());
    expect_exports_as_they_were();
}

TEST_F(Migration, ListsTheSameAsBefore) {
    const auto before = listed();
    open_store(folder()).reset();
    const auto after = listed();
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_EQ(after[i].id, before[i].id);
        EXPECT_EQ(after[i].names, before[i].names);
        EXPECT_EQ(after[i].shots, before[i].shots);
        EXPECT_EQ(after[i].games, before[i].games);
        EXPECT_EQ(after[i].wins, before[i].wins);
        if (after[i].id == kMatches.at("games")) {
            EXPECT_EQ(after[i].games, 3U);
            EXPECT_EQ(after[i].wins, (PerSeat<std::uint32_t>{2, 1}));
        }
    }
}

TEST_F(Migration, HasTheTablesOfANewStore) {
    open_store(folder()).reset();
    TemporaryFolder fresh;
    open_store(fresh.path()).reset();
    const auto columns_of = [](const fs::path& path) {
        SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
        SQLite::Statement query(database,
                                "SELECT m.name, c.cid, c.name, c.type, c.\"notnull\", c.dflt_value "
                                "FROM sqlite_schema m, pragma_table_info(m.name) c ORDER BY 1, 2");
        std::string text;
        while (query.executeStep()) {
            for (int i = 0; i < query.getColumnCount(); ++i)
                text += query.getColumn(i).getString() + " ";
            text += "\n";
        }
        return text;
    };
    EXPECT_EQ(columns_of(file()), columns_of(fresh.path() / "poolhall.sqlite"));
}

TEST_F(Migration, GoesOnWithTheOpenMatches) {
    const auto store = open_store(folder());
    const auto open = store->load_open_matches();
    ASSERT_TRUE(open) << open.error().reason;
    EXPECT_TRUE(open->damaged.empty());
    EXPECT_EQ(open->matches.size(), 5U);
    ASSERT_EQ(done(*store, AppendMoveJob{kMatches.at("open"), some_move(0)}), "ok");
    const std::string text = exported(folder(), kMatches.at("open"));
    EXPECT_TRUE(text.starts_with(read_file(kSamples / "open.jsonl")));
    EXPECT_NE(text.find(R"("kind":"move")"), std::string::npos);
}

TEST_F(Migration, NeverOverwritesACopyAndMakesNoneTwice) {
    write_file(copy(), "somebody's");
    fs::create_symlink("nowhere", copy(".2"));
    open_store(folder()).reset();
    EXPECT_EQ(read_file(copy()), "somebody's");
    EXPECT_TRUE(fs::is_symlink(copy(".2")));
    EXPECT_EQ(version_of(copy(".3")), 1);

    const std::string made = read_file(copy(".3"));
    write_file(file(), made);  // the old one is put back, and migrated once more
    open_store(folder()).reset();
    EXPECT_EQ(read_file(copy(".3")), made);
    EXPECT_FALSE(fs::exists(copy(".4")));
}

TEST_F(Migration, ADamagedRecordDoesNotStopTheOthers) {
    SQLite::Database(file().string(), SQLite::OPEN_READWRITE)
        .exec("UPDATE records SET body = 'no JSON' WHERE n = 3 AND match = 2");
    EXPECT_EQ(listed().size(), kMatches.size());
    EXPECT_EQ(open_failure(folder()), "ok");
    EXPECT_EQ(open_store(folder())->load_open_matches()->damaged.size(), 1U);
}

TEST_F(Migration, AFullDiskLeavesTheOldStoreUntouched) {
    const std::string before = read_file(file());
    for (const rlim_t room : {rlim_t{0}, rlim_t{40'000}, rlim_t{86'000}}) {
        const std::string failure = [&] {
            const FullDisk full(room);
            return open_failure(folder());
        }();
        EXPECT_NE(failure.find(file().string()), std::string::npos) << failure;
        EXPECT_EQ(failure.find('\n'), std::string::npos) << failure;
        EXPECT_EQ(read_file(file()), before) << room;
        EXPECT_FALSE(fs::exists(file().string() + ".part")) << room;
        expect_exports_as_they_were();
    }
    EXPECT_EQ(open_failure(folder()), "ok");
    expect_exports_as_they_were();
}

/// Kills a server that migrates after a while.
void kill_a_migration(const fs::path& folder, useconds_t life_us) {
    const pid_t child = fork();
    if (child == 0) {
        const auto store = ReplayStore::open({folder});
        _exit(store ? 0 : 1);
    }
    usleep(life_us);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
}

TEST_F(Migration, TakesInWhatAKilledServerLeftInItsLog) {
    const TemporaryFolder live;
    const fs::path database = live.path() / "poolhall.sqlite";
    fs::copy_file(file(), database);
    fs::permissions(database, fs::perms::owner_read | fs::perms::owner_write);
    SQLite::Database server(database.string(), SQLite::OPEN_READWRITE);
    server.exec("PRAGMA journal_mode = WAL");
    server.exec("UPDATE matches SET id = 'renamed' WHERE id = '" + kMatches.at("games") + "'");
    const std::string before = exported(live.path(), "renamed");
    EXPECT_TRUE(before.starts_with("{\"sum\":")) << before;
    for (const char* suffix : {"", "-wal", "-shm"}) {
        std::string name = std::string("poolhall.sqlite") + suffix;
        write_file(folder() / name, read_file(live.path() / name));
    }
    EXPECT_EQ(exported(folder(), "renamed"), before);
    open_store(folder()).reset();
    EXPECT_EQ(version_of(file()), protocol::kDatabaseVersion);
    EXPECT_EQ(exported(folder(), "renamed"), before);
    EXPECT_EQ(version_of(copy()), 1);
    fs::rename(copy(), file());
    EXPECT_EQ(exported(folder(), "renamed"), before);
}

TEST_F(Migration, AKillLeavesTheOldOrTheNewWhole) {
    std::map<int, int> versions;
    for (useconds_t life_us = 0; life_us < 40'000; life_us += 1000) {
        for (const auto& entry : fs::directory_iterator(folder()))
            fs::remove(entry.path());
        SetUp();
        kill_a_migration(folder(), life_us);
        expect_exports_as_they_were();
        const int version = version_of(file());
        ++versions[version];
        EXPECT_EQ(version_of(copy()) == 1, version == 2 || fs::exists(copy()));
        EXPECT_EQ(open_failure(folder()), "ok");
        expect_exports_as_they_were();
        EXPECT_EQ(version_of(copy()), 1);
        EXPECT_FALSE(fs::exists(copy(".2"))) << "one copy of one store is enough";
        EXPECT_FALSE(fs::exists(file().string() + ".part"));
    }
    EXPECT_GT(versions[1], 0);
}

}  // namespace
}  // namespace poolhall::server
