#include "client/lab/input/line_reader.hpp"

#include <gtest/gtest.h>
#include <sstream>
#include <string>

namespace poolhall::lab {
namespace {

TEST(LineReader, GivesLinesAndTheirNumbers) {
    std::istringstream in("one\n\nthree");
    LineReader reader(in);
    std::string line;
    ASSERT_EQ(reader.next(line), LineReader::Got::kLine);
    EXPECT_EQ(line, "one");
    ASSERT_EQ(reader.next(line), LineReader::Got::kLine);
    EXPECT_EQ(line, "");
    ASSERT_EQ(reader.next(line), LineReader::Got::kLine);
    EXPECT_EQ(line, "three");
    EXPECT_EQ(reader.number(), 3U);
    EXPECT_EQ(reader.next(line), LineReader::Got::kEnd);
}

TEST(LineReader, EmptyInputHasNoLine) {
    std::istringstream in;
    LineReader reader(in);
    std::string line;
    EXPECT_EQ(reader.next(line), LineReader::Got::kEnd);
}

TEST(LineReader, SkipsLinesThatAreTooLong) {
    const std::string longest(LineReader::kMaxLineBytes, 'a');
    std::istringstream in(longest + "\n" + longest + "b\nlast\n");
    LineReader reader(in);
    std::string line;
    ASSERT_EQ(reader.next(line), LineReader::Got::kLine);
    EXPECT_EQ(line, longest);
    ASSERT_EQ(reader.next(line), LineReader::Got::kTooLong);
    EXPECT_EQ(reader.number(), 2U);
    EXPECT_TRUE(line.empty());
    ASSERT_EQ(reader.next(line), LineReader::Got::kLine);
    EXPECT_EQ(line, "last");
    EXPECT_EQ(reader.next(line), LineReader::Got::kEnd);
}

TEST(LineReader, LinesThatEndWhereABlockEndsAreWhole) {
    for (std::size_t size : {(1U << 16U) - 1, 1U << 16U, (1U << 16U) + 1}) {
        const std::string text(size, 'a');
        std::istringstream in(text + "\nb\n");
        LineReader reader(in);
        std::string line;
        ASSERT_EQ(reader.next(line), LineReader::Got::kLine);
        EXPECT_EQ(line.size(), size);
        ASSERT_EQ(reader.next(line), LineReader::Got::kLine);
        EXPECT_EQ(line, "b");
    }
}

}  // namespace
}  // namespace poolhall::lab
