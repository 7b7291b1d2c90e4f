#include "protocol/archive/database.hpp"
#include "protocol/replay/line.hpp"
#include "protocol/replay/reader.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <regex>
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

TEST(ReplayFormatDocument, ItsExampleIsAWholeReplay) {
    std::istringstream file(block("jsonl"));
    ReplayReader reader(file);
    std::size_t kinds = 0;
    while (const auto record = reader.next())
        kinds |= std::size_t{1} << record->record.index();
    EXPECT_FALSE(reader.damage()) << reader.damage()->text();
    EXPECT_TRUE(reader.ended());
    EXPECT_EQ(kinds, (std::size_t{1} << std::variant_size_v<ReplayRecord>)-1)
        << "it shows every kind";
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
