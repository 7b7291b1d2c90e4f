#include "client/lab/output/columns.hpp"

#include <gtest/gtest.h>
#include <sstream>

namespace poolhall::lab {
namespace {

TEST(Columns, StandBelowEachOtherWithoutBlanksAtTheEnd) {
    Columns columns;
    columns.add({"solver", "cost"});
    columns.add({"event", "3 \xC2\xB5s", "fine"});
    columns.add({"x"});
    std::ostringstream out;
    columns.print(out);
    EXPECT_EQ(out.str(),
              "solver   cost\n"
              "event    3 \xC2\xB5s   fine\n"
              "x\n");
}

TEST(Columns, AWideCharacterTakesTwoPlaces) {
    Columns columns;
    columns.add({"\xE6\x9D\x8E", "1"});
    columns.add({"Li", "2"});
    std::ostringstream out;
    columns.print(out);
    EXPECT_EQ(out.str(), "\xE6\x9D\x8E   1\nLi   2\n");
}

}  // namespace
}  // namespace poolhall::lab
