#include "client/lab/bench/bench_rows.hpp"

#include <gtest/gtest.h>
#include <ostream>

namespace poolhall::lab {

void PrintTo(const BenchGroup& group, std::ostream* out) {
    *out << group.name;
}

namespace {

class Bench : public ::testing::TestWithParam<BenchGroup> {};

INSTANTIATE_TEST_SUITE_P(Groups, Bench, ::testing::ValuesIn(bench_groups()),
                         [](const auto& group) { return group.param.name; });

TEST_P(Bench, TimesRightAnswers) {
    for (const BenchRow& row : GetParam().run()) {
        EXPECT_FALSE(row.wrong) << row.name << " " << row.value << " " << row.unit << ": "
                                << row.check;
    }
}

}  // namespace
}  // namespace poolhall::lab
