#include "client/lab/accuracy/accuracy_command.hpp"

#include "client/lab/output/result_files.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

namespace poolhall::lab {
namespace {

using Json = nlohmann::ordered_json;

class Accuracy : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (std::filesystem::temp_directory_path() / "accuracyXXXXXX").string();
        folder = mkdtemp(pattern.data());
    }

    void TearDown() override { std::filesystem::remove_all(folder); }

    Status run(const AccuracyOptions& options) {
        out.str("");
        error.str("");
        return measure_accuracy(options, out, error);
    }

    [[nodiscard]] Json json() const {
        std::ifstream in(folder / "accuracy.json");
        return Json::parse(in);
    }

    [[nodiscard]] std::vector<std::string> csv() const {
        std::ifstream in(folder / "accuracy.csv");
        std::vector<std::string> lines;
        for (std::string line; std::getline(in, line);)
            lines.push_back(line);
        return lines;
    }

    /// A short run of some parts, written to the folder.
    [[nodiscard]] AccuracyOptions small(std::vector<std::string> parts) const {
        AccuracyOptions options;
        options.plan.quick = true;
        options.plan.shots = 3;
        options.plan.seed = 5;
        options.out = folder.string();
        options.only = std::move(parts);
        return options;
    }

    std::filesystem::path folder;
    std::ostringstream out;
    std::ostringstream error;
};

/// All but what was timed.
Json without_times(Json json) {
    json.erase("seconds");
    for (Json& ensemble : json["ensembles"]) {
        for (Json& point : ensemble["points"]) {
            for (const char* time : {"ns", "instructions", "worst_tick_ns"})
                point["cost"].erase(time);
        }
    }
    for (Json& crowd : json["crowds"])
        crowd.erase("ns");
    return json;
}

TEST_F(Accuracy, IsReproducibleFromItsSeedInAllButTimes) {
    const AccuracyOptions options = small({"two_balls", "end_game", "tunnelling"});
    ASSERT_EQ(run(options), Status::kGood);
    const Json first = json();
    ASSERT_EQ(run(options), Status::kGood);
    EXPECT_EQ(without_times(first), without_times(json()));
    AccuracyOptions other = options;
    other.plan.seed = 6;
    ASSERT_EQ(run(other), Status::kGood);
    EXPECT_NE(without_times(first)["ensembles"], without_times(json())["ensembles"]);
}

TEST_F(Accuracy, WritesWhatTheContractSays) {
    ASSERT_EQ(run(small({"two_balls"})), Status::kGood);
    const Json all = json();
    EXPECT_EQ(all["schema"], "poolhall.accuracy/1");
    EXPECT_EQ(all["command"], "poolhall-lab accuracy --quick --shots 3 --seed 5 --only two_balls");
    EXPECT_EQ(all["complete"], true);
    const Json& ensemble = all["ensembles"][0];
    EXPECT_EQ(ensemble["name"], "two_balls");
    EXPECT_EQ(ensemble["shots"], 3);
    EXPECT_EQ(ensemble["reference"], "event solver in 113 bits");
    const Json& points = ensemble["points"];
    ASSERT_EQ(points.size(), 4 * 7 + 1U);
    EXPECT_EQ(points[0]["label"], "euler:30");
    EXPECT_EQ(points[0]["kernel"], "slide_roll_spin");
    EXPECT_GT(points[0]["cost"]["ns"], 0);
    EXPECT_GT(points[0]["rest_error"]["median"], points[6]["rest_error"]["median"]);
    const Json& event = points.back();
    EXPECT_EQ(event["label"], "event");
    EXPECT_TRUE(event["hz"].is_null());
    EXPECT_LT(event["rest_error"]["max"], 1e-9);
    EXPECT_EQ(event["matching_events"]["share"], 1);
    EXPECT_EQ(event["verdict_flips"], 0);
    EXPECT_EQ(ensemble["error_in_time"].back()["label"], "event");
    EXPECT_EQ(ensemble["error_in_time"][0]["t"][1], 0.1);
    const auto lines = csv();
    ASSERT_EQ(lines.size(), points.size() + 1);
    EXPECT_TRUE(lines[0].starts_with("ensemble,shots,reference,label,solver,hz,kernel,ns,"));
    EXPECT_TRUE(
        lines[1].starts_with("two_balls,3,\"event solver in 113 bits\",euler:30,euler,30,"));
    for (const std::string& line : lines) {
        EXPECT_EQ(std::count(line.begin(), line.end(), ','),
                  std::count(lines[0].begin(), lines[0].end(), ','));
    }
}

/// Somebody who presses Ctrl-C when the first table comes.
class Impatient : public std::stringbuf {
  protected:
    std::streamsize xsputn(const char* text, std::streamsize size) override {
        if (std::string_view(text, static_cast<std::size_t>(size)).find("order of") !=
            std::string_view::npos)
            std::raise(SIGINT);
        return std::stringbuf::xsputn(text, size);
    }
};

TEST_F(Accuracy, CtrlCKeepsWhatIsFinished) {
    Impatient reader;
    std::ostream to_reader(&reader);
    EXPECT_EQ(measure_accuracy(small({"two_balls", "end_game", "crowds"}), to_reader, error),
              Status::kInterrupted);
    EXPECT_EQ(error.str(),
              "poolhall-lab: interrupted; what was finished is in " + folder.string() + "\n");
    const Json kept = json();
    EXPECT_EQ(kept["complete"], false);
    ASSERT_EQ(kept["ensembles"].size(), 1U);
    EXPECT_EQ(kept["ensembles"][0]["name"], "two_balls");
    EXPECT_TRUE(kept["crowds"].empty());
}

TEST_F(Accuracy, OverlapMissesWhatSweptContactsFind) {
    ASSERT_EQ(run(small({"tunnelling"})), Status::kGood);
    const Json found = json();
    for (const Json& one : found["tunnelling"]) {
        const double missed = one["missed"].back();  // at 30 m/s
        if (one["label"] == "euler:30") {
            EXPECT_EQ(missed, 0);
        } else if (one["label"] == "overlap:30") {
            EXPECT_NEAR(missed, 0.91, 0.05);  // PHYSICS.md
        }
    }
}

TEST_F(Accuracy, AFolderThatCannotBeWrittenIsSaidBeforeTheRun) {
    AccuracyOptions options = small({});
    std::ofstream(folder / "file") << "in the way";
    options.out = (folder / "file").string();
    EXPECT_EQ(run(options), Status::kBadInput);
    EXPECT_EQ(out.str(), "");
    EXPECT_TRUE(error.str().starts_with("poolhall-lab: " + options.out)) << error.str();
    options.out = "/proc/nowhere";
    EXPECT_EQ(run(options), Status::kBadInput);
    EXPECT_EQ(out.str(), "");
}

TEST_F(Accuracy, OlderResultsStayUntilThereAreNewOnes) {
    std::ofstream(folder / "accuracy.json") << "old";
    {
        const ResultFiles files(folder, "accuracy");
        EXPECT_FALSE(files.fault());
    }
    std::ifstream in(folder / "accuracy.json");
    std::string text;
    in >> text;
    EXPECT_EQ(text, "old");
    const std::filesystem::directory_iterator entries(folder);
    EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

}  // namespace
}  // namespace poolhall::lab
