#include "client/lab/corpora/corpora.hpp"

#include "shared/physics/simulate.hpp"

#include <gtest/gtest.h>
#include <string>

namespace poolhall::lab {

void PrintTo(const Corpus& corpus, std::ostream* out) {
    *out << corpus.name;
}

namespace {

class CorpusTest : public ::testing::TestWithParam<Corpus> {};

INSTANTIATE_TEST_SUITE_P(All, CorpusTest, ::testing::ValuesIn(corpora()),
                         [](const auto& test) { return std::string(test.param.name); });

/// What is hashed, and so guarded, must be good.
TEST_P(CorpusTest, HasShotsThatComeToRest) {
    Simulator simulator;
    ShotTrace trace;
    int shot = 0;
    for (const Scene& scene : scenes_of(GetParam())) {
        simulator.simulate(scene, 0, trace);
        EXPECT_EQ(Outcome::kRest, trace.outcome) << "shot " << shot;
        ++shot;
    }
}

}  // namespace
}  // namespace poolhall::lab
