#include "protocol/archive/database.hpp"
#include "protocol/replay/line.hpp"
#include "protocol/replay/log_follower.hpp"
#include "protocol/replay/reader.hpp"
#include "protocol/replay/record_fields.hpp"
#include "shared/game/end_game.hpp"
#include "tests/protocol/replay/followed.hpp"
#include "tests/protocol/replay/played_match.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

// REPLAY_FORMAT.md says what the code does.
namespace poolhall::protocol {
namespace {

std::string document() {
    std::ifstream file(POOLHALL_SOURCE_DIR "/protocol/REPLAY_FORMAT.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The text between ```kind and ``` of the document.
std::string block(const std::string& kind) {
    const std::string text = document();
    const std::size_t begin = text.find("```" + kind + "\n");
    if (begin == std::string::npos) return {};
    const std::size_t first_line = text.find('\n', begin) + 1;
    return text.substr(first_line, text.find("```", first_line) - first_line);
}

std::string without_extra_spaces(const std::string& text) {
    return std::regex_replace(text, std::regex("\\s+"), " ");
}

TEST(ReplayFormatDocument, EveryChecksumInItsTableIsRight) {
    const std::string text = document();
    for (const std::string_view bytes :
         {"a", "foobar", R"({"n":2,"kind":"seat","seat":0,"name":"Ann"})"}) {
        const std::string row = "| `" + std::string(bytes) + "` | `" + checksum_text(bytes) + "` |";
        EXPECT_NE(text.find(row), std::string::npos) << row;
    }
    EXPECT_NE(text.find("| (none) | `" + checksum_text("") + "` |"), std::string::npos);
}

/// The match that the page shows, as it is logged.
std::string documented_match() {
    MatchSettings settings;
    settings.shot_clock_s = 30;
    MatchRecord first = test::match_record("7c9f0a2e");
    first.settings = settings;
    std::vector<ReplayRecord> records{first, SeatRecord{Seat{0}, "Ann"},
                                      SeatRecord{Seat{1}, "Bob"}};
    std::int64_t now = first.created_ms;
    Match match({&kEndGameRules, Seat{0}, settings});
    match.start_clock(now);
    const auto play = [&](Seat seat, const Move& move, std::int64_t after_ms) {
        now += after_ms;
        MatchStep step = match.play(seat, move, now);
        records.emplace_back(move_record(step));
        match.commit(std::move(step), now);
    };
    play(Seat{0}, Place{{end_game::kBaseLineX, 0.01}}, 5'000);
    play(Seat{0}, Shoot{Stroke{{0.7798546875, -0.05682728125000001}, {}}}, 5'000);
    play(Seat{0}, Agree{}, 10'000);
    play(Seat{1}, Agree{}, 1'000);
    play(Seat{1}, TimeOut{}, 30'000);
    play(Seat{0}, Concede{}, 4'000);
    records.emplace_back(EndRecord{"both players left", now + 5'000});
    return test::replay_file(records);
}

/// The kinds of the records of a whole file, which must be one that deviates in nothing.
std::set<std::string> kinds_of(const std::string& text) {
    std::istringstream file(text);
    ReplayReader reader(file);
    LogFollower follower;
    std::set<std::string> kinds;
    while (const auto record = reader.next()) {
        kinds.emplace(kind_of(record->record));
        const Followed followed = follower.follow(record->record);
        EXPECT_EQ(test::first(followed.found.deviations), "nothing") << followed.subject;
    }
    EXPECT_FALSE(reader.damage()) << reader.damage()->text();
    EXPECT_TRUE(reader.ended());
    return kinds;
}

TEST(ReplayFormatDocument, ItsExampleIsAWholeReplayWithEveryKind) {
    EXPECT_EQ(block("jsonl"), documented_match());
    EXPECT_EQ(kinds_of(block("jsonl")), (std::set<std::string>{"match", "seat", "move", "end"}));
}

TEST(ReplayFormatDocument, ItsExampleOfVersion1IsAWholeReplayWithEveryKind) {
    EXPECT_EQ(kinds_of(block("jsonl-1")),
              (std::set<std::string>{"match", "seat", "game", "shot", "end"}));
}

/// Whether the page has the name of every field.
template <class... Records>
void expect_fields() {
    const std::string text = document();
    const auto expect = [&](std::string_view name) {
        EXPECT_NE(text.find("`" + std::string(name) + "`"), std::string::npos) << name;
    };
    const auto expect_all = [&](const auto& fields) {
        std::apply([&](const auto&... field) { (expect(field.name), ...); }, fields);
    };
    (expect_all(wire::kFields<Records>), ...);
}

TEST(ReplayFormatDocument, ItNamesEveryFieldAndKind) {
    expect_fields<MatchRecord, SeatRecord, MoveRecord, ShotEvidence, EndRecord, GameRecord,
                  ShotRecord>();
    for (const std::string_view kind : {MatchRecord::kKind, SeatRecord::kKind, MoveRecord::kKind,
                                        EndRecord::kKind, GameRecord::kKind, ShotRecord::kKind})
        EXPECT_NE(document().find("**`" + std::string(kind) + "`**"), std::string::npos) << kind;
}

TEST(ReplayFormatDocument, ItsTablesAreThoseOfTheStore) {
    const std::string documented = without_extra_spaces(block("sql"));
    SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    create_tables(database);
    SQLite::Statement tables(database, "SELECT sql FROM sqlite_schema WHERE sql IS NOT NULL");
    std::size_t count = 0;
    for (; tables.executeStep(); ++count) {
        const std::string sql = without_extra_spaces(tables.getColumn(0).getString()) + ";";
        EXPECT_NE(documented.find(sql), std::string::npos) << sql;
    }
    EXPECT_EQ(count,
              static_cast<std::size_t>(std::count(documented.begin(), documented.end(), ';')));
}

}  // namespace
}  // namespace poolhall::protocol
