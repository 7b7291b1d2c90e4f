#include "protocol/replay/reader.hpp"

#include "protocol/replay/line.hpp"
#include "protocol/replay/record_text.hpp"
#include "tests/protocol/replay/played_match.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace poolhall::protocol {
namespace {

constexpr std::uint32_t kShots = 3;

/// What reading a whole file gives.
struct Reading {
    std::size_t records = 0;
    bool ended = false;
    std::optional<Damage> damage;
};

Reading read(const std::string& file) {
    std::istringstream input(file);
    ReplayReader reader(input);
    Reading reading;
    while (const auto record = reader.next())
        EXPECT_EQ(record->n, ++reading.records);
    reading.ended = reader.ended();
    reading.damage = reader.damage();
    return reading;
}

std::size_t lines_before(const std::string& file, std::size_t offset) {
    const auto end = file.begin() + static_cast<std::ptrdiff_t>(offset);
    return static_cast<std::size_t>(std::count(file.begin(), end, '\n'));
}

std::size_t line_start(const std::string& file, std::size_t offset) {
    return offset == 0 ? 0 : file.rfind('\n', offset - 1) + 1;
}

/// The file of a match, line by line.
std::vector<std::string> lines_of(std::vector<ReplayRecord> records) {
    std::vector<std::string> lines;
    for (const ReplayRecord& record : records)
        lines.push_back(test::replay_line(lines.size() + 1, record));
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string file;
    for (const std::string& line : lines)
        file += line;
    return file;
}

TEST(ReplayReader, ReadsAWholeFile) {
    const auto records = test::played_match("m1", kShots);
    const Reading reading = read(test::replay_file(records));
    EXPECT_EQ(reading.records, records.size());
    EXPECT_TRUE(reading.ended);
    EXPECT_FALSE(reading.damage);
}

TEST(ReplayReader, GivesTheTextAsItStands) {
    const auto lines = lines_of(test::played_match("m1", kShots));
    std::istringstream input(joined(lines));
    ReplayReader reader(input);
    for (const std::string& line : lines) {
        ASSERT_TRUE(reader.next());
        EXPECT_EQ(to_line({checksum_text(reader.text()), reader.text()}), line);
    }
    EXPECT_FALSE(reader.next());
    EXPECT_EQ(reader.text(), "");
}

TEST(ReplayReader, LinesMayEndWithCarriageReturnAndLineFeed) {
    std::string file;
    const auto records = test::played_match("m1", kShots);
    for (const char byte : test::replay_file(records))
        file += byte == '\n' ? std::string("\r\n") : std::string(1, byte);
    const Reading reading = read(file);
    EXPECT_EQ(reading.records, records.size());
    EXPECT_TRUE(reading.ended);
    EXPECT_FALSE(reading.damage) << reading.damage->text();

    std::istringstream input(file);
    ReplayReader reader(input);
    ASSERT_TRUE(reader.next());
    EXPECT_FALSE(reader.text().ends_with('\r'));
    EXPECT_EQ(read(file.substr(0, file.size() - 1)).damage->kind, DamageKind::kTornLine);
    EXPECT_EQ(read("\r" + file).damage->kind, DamageKind::kNotARecord);
}

TEST(ReplayReader, ATruncatedFileIsReadUpToTheCut) {
    const std::string file = test::replay_file(test::played_match("m1", kShots));
    for (std::size_t size = 0; size < file.size(); ++size) {
        const Reading reading = read(file.substr(0, size));
        EXPECT_EQ(reading.records, lines_before(file, size));
        EXPECT_FALSE(reading.ended);
        const bool between_lines = size > 0 && file[size - 1] == '\n';
        ASSERT_EQ(reading.damage.has_value(), !between_lines) << "cut at " << size;
        if (between_lines) continue;
        EXPECT_EQ(reading.damage->kind,
                  size == 0 ? DamageKind::kMissingRecord : DamageKind::kTornLine);
        EXPECT_EQ(reading.damage->offset, line_start(file, size));
        EXPECT_EQ(reading.damage->line, reading.records + 1);
    }
}

TEST(ReplayReader, AnyWrongByteIsFoundInItsLine) {
    const std::string file = test::replay_file(test::played_match("m1", 1));
    for (std::size_t at = 0; at < file.size(); ++at) {
        for (const unsigned flip : {0x01U, 0x20U, 0x80U, 0xFFU}) {
            std::string damaged = file;
            damaged[at] = static_cast<char>(static_cast<unsigned char>(file[at]) ^ flip);
            const Reading reading = read(damaged);
            ASSERT_TRUE(reading.damage) << "byte " << at << " xor " << flip;
            EXPECT_EQ(reading.damage->line, lines_before(file, at) + 1);
            EXPECT_EQ(reading.damage->offset, line_start(file, at));
            EXPECT_EQ(reading.records, lines_before(file, at));
        }
    }
}

TEST(ReplayReader, AMissingLineIsNoticed) {
    const auto lines = lines_of(test::played_match("m1", kShots));
    for (std::size_t missing = 0; missing + 1 < lines.size(); ++missing) {
        auto rest = lines;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(missing));
        const Reading reading = read(joined(rest));
        ASSERT_TRUE(reading.damage);
        EXPECT_EQ(reading.damage->kind, DamageKind::kMissingRecord);
        EXPECT_EQ(reading.damage->line, missing + 1);
        EXPECT_EQ(reading.records, missing);
    }
}

TEST(ReplayReader, ARepeatedOrSwappedLineIsNoticed) {
    auto lines = lines_of(test::played_match("m1", kShots));
    std::swap(lines[3], lines[4]);
    EXPECT_EQ(read(joined(lines)).damage->text(),
              "line 4, byte " +
                  std::to_string(lines[0].size() + lines[1].size() + lines[2].size()) +
                  ": record 5 stands where record 4 must be");
    std::swap(lines[3], lines[4]);
    lines.insert(lines.begin() + 2, lines[2]);
    EXPECT_EQ(read(joined(lines)).damage->line, 4U);
}

TEST(ReplayReader, AMatchBeginsOnceAndEndsOnce) {
    const MatchRecord match = test::match_record("m1");
    const EndRecord end{"over", 1};
    const SeatRecord seat{Seat{0}, "Ann"};
    EXPECT_EQ(read(joined(lines_of({seat}))).damage->kind, DamageKind::kOutOfPlace);
    EXPECT_EQ(read(joined(lines_of({match, match}))).damage->kind, DamageKind::kOutOfPlace);
    EXPECT_EQ(read(joined(lines_of({match, end, seat}))).damage->kind, DamageKind::kOutOfPlace);
    EXPECT_FALSE(read(joined(lines_of({match, end}))).damage);
}

TEST(ReplayReader, SaysWhichFieldIsBad) {
    std::string record = to_text(1, test::match_record("m1"));
    record.replace(record.find("m1"), 2, "..");
    const Reading reading = read(to_line({checksum_text(record), record}));
    ASSERT_TRUE(reading.damage);
    EXPECT_EQ(reading.damage->kind, DamageKind::kBadField);
    EXPECT_EQ(reading.damage->text(), "line 1, byte 0: /match: must be 1 to 64 of A-Z a-z 0-9 _ -");
}

TEST(ReplayReader, SaysThatAVersionIsUnknownBeforeAnythingElse) {
    std::string record = to_text(1, test::match_record("m1"));
    record.replace(record.find("poolhall.replay/2"), 17, "poolhall.replay/3");
    record.replace(record.find("\"game\""), 6, "\"rules\"");
    const Reading reading = read(to_line({checksum_text(record), record}));
    ASSERT_TRUE(reading.damage);
    EXPECT_EQ(reading.damage->kind, DamageKind::kUnknownVersion);
    EXPECT_EQ(
        reading.damage->text(),
        "line 1, byte 0: /format: the version \"poolhall.replay/3\" is none that this program "
        "knows: it reads \"poolhall.replay/1\" and \"poolhall.replay/2\"");
}

TEST(ReplayReader, ReadsMovesThatGoOnWithAMatchOfVersion1) {
    auto records = test::played_match_v1("m1", kShots);
    records.pop_back();
    records.emplace_back(test::some_move(0));
    EXPECT_EQ(read(test::replay_file(records)).records, records.size());
}

TEST(ReplayReader, SaysWhenARecordIsNoJson) {
    const std::string record = "{]";
    EXPECT_EQ(read(to_line({checksum_text(record), record})).damage->kind, DamageKind::kBadJson);
}

TEST(ReplayReader, AnEndlessLineIsNotReadToItsEnd) {
    const Reading reading = read(std::string(3 * kMaxReplayLineBytes, 'x'));
    ASSERT_TRUE(reading.damage);
    EXPECT_EQ(reading.damage->kind, DamageKind::kLineTooLong);
}

TEST(ReplayReader, AFolderIsNoFile) {
    std::ifstream folder("/");
    ReplayReader reader(folder);
    EXPECT_FALSE(reader.next());
    EXPECT_TRUE(reader.damage());
}

}  // namespace
}  // namespace poolhall::protocol
