#include "client/lab/effects/effects_command.hpp"

#include "client/lab/effects/effect_cases.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace poolhall::lab {
namespace {

using nlohmann::json;

class EffectsCommand : public ::testing::Test {
  protected:
    EffectsCommand()
        : folder(std::filesystem::path(::testing::TempDir()) /
                 ("effects_" +
                  std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        std::filesystem::remove_all(folder);
    }

    ~EffectsCommand() override { std::filesystem::remove_all(folder); }

    /// Runs it on few shots; the results without their times.
    json run(std::uint64_t seed) {
        EXPECT_EQ(Status::kGood,
                  measure_effects({{seed, true, 2}, folder.string(), false}, out, error))
            << error.str();
        json result = json::parse(std::ifstream(folder / "effects.json"));
        return result;
    }

    /// What of it hangs on the seed alone.
    static json outcomes(const json& result) {
        json all = json::array();
        for (const json& effect : result["effects"])
            all.push_back({effect["effect"], effect["rest_change"], effect["verdict_flips"]});
        return all;
    }

    std::filesystem::path folder;
    std::ostringstream out;
    std::ostringstream error;
};

TEST_F(EffectsCommand, WritesARowForEveryKernelAndEffect) {
    const json result = run(1);
    EXPECT_EQ("poolhall.effects/1", result["schema"]);
    EXPECT_EQ(true, result["complete"]);
    ASSERT_EQ(kernel_cases().size(), result["kernels"].size());
    ASSERT_EQ(effect_cases().size(), result["effects"].size());
    for (const json& kernel : result["kernels"])
        EXPECT_GT(kernel["per_shot"]["ns"], 0) << kernel;
    for (const json& effect : result["effects"]) {
        EXPECT_GT(effect["present"]["ns_per_event"], 0) << effect;
        EXPECT_NE(std::string::npos, out.str().find(effect["effect"].get<std::string>()));
    }
    ASSERT_EQ(4U, result["play"].size());
    for (const json& kind : result["play"]) {
        EXPECT_GT(kind["per_shot"]["ns"], 0) << kind;
        for (const json& effect : kind["effects"])
            EXPECT_LE(effect["acted"], effect["called_for"]) << kind;
    }
    std::ifstream csv(folder / "effects.csv");
    std::size_t lines = 0;
    for (std::string line; std::getline(csv, line); ++lines)
        EXPECT_EQ(13, std::count(line.begin(), line.end(), ',')) << line;
    EXPECT_GT(lines, 1 + kernel_cases().size() + 2 * effect_cases().size());
}

TEST_F(EffectsCommand, GivesTheSameForTheSameSeedButTimes) {
    const json first = outcomes(run(7));
    EXPECT_EQ(first, outcomes(run(7)));
    EXPECT_NE(first, outcomes(run(8)));
}

TEST_F(EffectsCommand, SaysAtOnceThatTheFolderCannotBeMade) {
    std::ofstream(folder.string()) << "a file";
    EXPECT_EQ(Status::kBadInput,
              measure_effects({{1, true, 2}, (folder / "under").string(), false}, out, error));
    EXPECT_NE(std::string::npos, error.str().find(folder.string())) << error.str();
    EXPECT_EQ("", out.str());
}

TEST_F(EffectsCommand, SaysAtOnceThatInstructionsCannotBeCounted) {
    EXPECT_EQ(Status::kBadInput,
              measure_effects({{1, true, 2}, "", false, "/nowhere/lab"}, out, error));
    EXPECT_EQ("poolhall-lab: valgrind cannot count instructions of /nowhere/lab\n", error.str());
    EXPECT_EQ("", out.str());
}

}  // namespace
}  // namespace poolhall::lab
