#include "client/lab/input/scene_source.hpp"

#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

namespace poolhall::lab {
namespace {

/// "1 {...}" or "2 what is wrong", for each scene of the input.
std::vector<std::string> read(const std::string& input) {
    std::istringstream in(input);
    SceneSource source(in);
    std::vector<std::string> found;
    while (const auto text = source.next()) {
        found.push_back(std::to_string(text->line) + " " +
                        (text->tree ? text->tree->dump() : text->tree.error()));
    }
    return found;
}

using Found = std::vector<std::string>;

TEST(SceneSource, TakesALineAtATimeAndSkipsBlankOnes) {
    EXPECT_EQ(read("{\"a\":1}\n\n  \r\n{\"b\":2}\r\n"), (Found{"1 {\"a\":1}", "4 {\"b\":2}"}));
    EXPECT_EQ(read(""), Found{});
    EXPECT_EQ(read("\n\n"), Found{});
}

TEST(SceneSource, TakesOneObjectOverManyLines) {
    EXPECT_EQ(read("\n{\n  \"a\": [\n\n    {\"b\": 1}\n  ]\n}\n"), Found{"2 {\"a\":[{\"b\":1}]}"});
}

TEST(SceneSource, NamesTheLineAndByteOfASyntaxError) {
    EXPECT_EQ(read("{\"a\":1}\n{\"a\":x}\n{\"b\":2}\n"),
              (Found{"1 {\"a\":1}", "2 a syntax error at byte 6", "3 {\"b\":2}"}));
    EXPECT_EQ(read("{\n  \"a\": 1,\n  \"b\": x\n}\n"), Found{"3 a syntax error at byte 8"});
}

TEST(SceneSource, SaysWhereAnObjectDoesNotEnd) {
    EXPECT_EQ(read("{\"a\":1}\n{\"a\":"),
              (Found{"1 {\"a\":1}", "2 a syntax error at byte 6, the end"}));
    EXPECT_EQ(read("{\n  \"a\": 1,\n"), Found{"2 a syntax error at byte 10, the end"});
}

TEST(SceneSource, ABrokenFirstLineDoesNotSwallowTheScenesBehindIt) {
    EXPECT_EQ(read("{\"a\":\n{\"a\":\n{\"schema\":1}\n{\"schema\":2}\n"),
              (Found{"1 a syntax error at byte 6, the end", "2 a syntax error at byte 6, the end",
                     "3 {\"schema\":1}", "4 {\"schema\":2}"}));
}

TEST(SceneSource, RefusesWhatIsTooLong) {
    const std::string huge(LineReader::kMaxLineBytes + 1, ' ');
    EXPECT_EQ(read("{\"a\":1}\n" + huge + "\n{\"b\":2}\n"),
              (Found{"1 {\"a\":1}", "2 is longer than 16 MiB", "3 {\"b\":2}"}));
    std::string endless = "{\n";
    while (endless.size() <= LineReader::kMaxLineBytes)
        endless += "  \"a long line of an object that goes on and on\": [1, 2, 3],\n";
    EXPECT_EQ(read(endless + endless), Found{"1 is longer than 16 MiB"});
}

TEST(SceneSource, RefusesDuplicateKeysAndDeepNesting) {
    EXPECT_EQ(read("{\"a\":1,\"a\":2}\n"), Found{"1 the key a twice in one object"});
    EXPECT_EQ(read(std::string(100000, '[') + "\n"),
              Found{"1 arrays or objects nested too deeply"});
}

}  // namespace
}  // namespace poolhall::lab
