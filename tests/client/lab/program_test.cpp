// The real program: its input, output and exit status.

#include "protocol/text.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace poolhall::lab {
namespace {

using Json = nlohmann::ordered_json;

struct ProgramRun {
    int status = -1;
    std::vector<std::string> out;  ///< lines
    std::vector<std::string> error;
};

std::vector<std::string> lines_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

class LabProgram : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (std::filesystem::temp_directory_path() / "labXXXXXX").string();
        folder = mkdtemp(pattern.data());
    }

    void TearDown() override { std::filesystem::remove_all(folder); }

    [[nodiscard]] std::string path(const std::string& name) const {
        return (folder / name).string();
    }

    /// Runs `poolhall-lab ARGUMENTS` with the text as standard input.
    [[nodiscard]] ProgramRun run(const std::string& arguments,
                                 const std::string& input = "") const {
        std::ofstream(path("in")) << input;
        const std::string command = POOLHALL_LAB " " + arguments + " <" + path("in") + " >" +
                                    path("out") + " 2>" + path("error");
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, lines_of(path("out")),
                lines_of(path("error"))};
    }

    std::filesystem::path folder;
};

/// A cue ball that hits an object ball.
Json scene(const std::string& id) {
    return Json::parse(R"({"schema": "poolhall.scene/1", "id": ")" + id + R"(",
        "table": {"length": 2.54, "width": 1.27}, "effects": {"sliding": {}, "rolling": {}},
        "solver": {"kind": "event"},
        "balls": [{"id": "cue", "r": [-0.5, 0]}, {"id": "1", "r": [0.5, 0.01]}],
        "strike": {"ball": "cue", "direction": [1, 0], "speed": 2}})");
}

std::string line(const std::string& id) {
    return scene(id).dump() + "\n";
}

TEST_F(LabProgram, GivesAResultALineInTheOrderOfTheScenes) {
    const ProgramRun run = this->run("simulate", line("a") + line("b") + line("c"));
    EXPECT_EQ(run.status, 0);
    EXPECT_TRUE(run.error.empty());
    ASSERT_EQ(run.out.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const Json result = Json::parse(run.out[i]);
        EXPECT_EQ(result["schema"], "poolhall.result/1");
        EXPECT_EQ(result["id"], std::string(1, static_cast<char>('a' + i)));
        EXPECT_EQ(result["cost"]["events"], result["events"].size());
        EXPECT_GT(result["cost"]["ns"], 0);
    }
}

TEST_F(LabProgram, ReadsAFileWithOneObjectOverManyLines) {
    std::ofstream(path("scene.json")) << scene("spread").dump(2);
    const ProgramRun run = this->run("simulate " + path("scene.json"));
    EXPECT_EQ(run.status, 0);
    ASSERT_EQ(run.out.size(), 1U);
    EXPECT_EQ(Json::parse(run.out[0])["id"], "spread");
}

TEST_F(LabProgram, NamesBadLinesAndDoesTheOthers) {
    Json overlap = scene("overlap");
    overlap["balls"][1]["r"] = {-0.5, 0.01};
    Json nan = scene("nan");
    nan["strike"]["speed"] = "nan";
    const ProgramRun run =
        this->run("simulate -", line("a") + "{\"schema\": x}\n" + overlap.dump() + "\n\n" +
                                    line("b") + nan.dump() + "\n[]\n");
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.out.size(), 2U);
    EXPECT_EQ(run.error,
              (std::vector<std::string>{
                  "line 2: a syntax error at byte 12", "line 3: /balls/1/r: overlaps /balls/0",
                  "line 6: /strike/speed: must be a number or a finite C hex-float string",
                  "line 7: the scene must be an object"}));
}

TEST_F(LabProgram, TakesAnotherSolver) {
    const ProgramRun run = this->run("simulate --solver semi_implicit:120", line("a"));
    ASSERT_EQ(run.out.size(), 1U);
    const Json result = Json::parse(run.out[0]);
    EXPECT_EQ(result["solver"], "semi_implicit");
    EXPECT_GT(result["cost"]["ticks"], 100);
}

TEST_F(LabProgram, TheOtherSolverCountsWhereTheScenesOwnCannot) {
    Json dragged = scene("dragged");
    dragged["effects"]["linear_drag"] = {{"k", 0.6}, {"stop_speed", 0.06}};
    const ProgramRun own = run("simulate", dragged.dump());
    EXPECT_EQ(own.status, 2);
    ASSERT_EQ(own.error.size(), 1U);
    EXPECT_TRUE(own.error[0].starts_with("line 1: /solver/kind: ")) << own.error[0];
    EXPECT_EQ(run("simulate --solver euler:60", dragged.dump()).status, 0);
    dragged.erase("solver");
    EXPECT_EQ(run("simulate --solver euler:60", dragged.dump()).status, 0);
}

TEST_F(LabProgram, HexFormTellsTheSameBits) {
    const Json decimal = Json::parse(run("simulate", line("a")).out.at(0));
    const Json hex = Json::parse(run("simulate --hex", line("a")).out.at(0));
    EXPECT_EQ(hex["hash"], decimal["hash"]);
    EXPECT_EQ(protocol::parse_hex_float(hex["duration"].get<std::string>()),
              decimal["duration"].get<double>());
    EXPECT_EQ(protocol::parse_hex_float(hex["balls"][1]["r"][1].get<std::string>()),
              decimal["balls"][1]["r"][1].get<double>());
}

TEST_F(LabProgram, SamplesAreTakenAtTheirRate) {
    const Json result = Json::parse(run("simulate --sample 10", line("a")).out.at(0));
    ASSERT_GT(result["samples"].size(), 20U);
    EXPECT_EQ(result["samples"][7]["t"], 0.7);
    EXPECT_EQ(result["samples"][0]["r"], Json::parse("[[-0.5, 0.0, 0.0], [0.5, 0.01, 0.0]]"));
    EXPECT_EQ(result["hash"], Json::parse(run("simulate", line("a")).out.at(0))["hash"]);
}

TEST_F(LabProgram, RefusesMoreSamplesThanFitIntoMemory) {
    Json endless = scene("endless");
    endless["effects"] = Json::object();
    endless["solver"] = {{"kind", "exact_arc"}};
    const ProgramRun run = this->run("simulate --sample 1e6", endless.dump());
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.error, std::vector<std::string>{
                             "line 1: the scene needs more than 10 million samples of a ball"});
}

TEST_F(LabProgram, RefusesFilesThatCannotBeRead) {
    const ProgramRun missing = run("simulate " + path("missing.json"));
    EXPECT_EQ(missing.status, 2);
    EXPECT_EQ(missing.error, std::vector<std::string>{"poolhall-lab: " + path("missing.json") +
                                                      " cannot be opened"});
    const ProgramRun of_folder = run("simulate " + folder.string());
    EXPECT_EQ(of_folder.status, 2);
    EXPECT_EQ(of_folder.error,
              std::vector<std::string>{"poolhall-lab: " + folder.string() + " is a folder"});
}

TEST_F(LabProgram, RefusesBadOptions) {
    for (const char* arguments :
         {"", "simulate --solver rk4", "simulate --sample nan", "simulate --sample -1",
          "simulate a b", "fly", "bench --csv /nowhere/x.csv", "accuracy --shots 0",
          "accuracy --shots many", "accuracy --seed -1", "accuracy --seed 1e30",
          "accuracy --only three_balls", "accuracy --out /proc/nowhere", "accuracy 7",
          "validate --threads 0", "validate --recorded /nowhere/shots.json",
          "validate --out /proc/nowhere", "validate 7"})
        EXPECT_EQ(run(arguments).status, 2) << arguments;
    EXPECT_EQ(run("--help").status, 0);
}

TEST_F(LabProgram, AccuracyEndsAtCtrlC) {
    const std::string accuracy =
        POOLHALL_LAB " accuracy --shots 100000 --only one_ball --out " + path("out");
    const std::string script =
        accuracy + " >" + path("text") + " 2>" + path("error") +
        " & program=$!; sleep 1; kill -INT $program; wait $program; echo $? >" + path("status");
    // Without job control a shell makes its background programs deaf to Ctrl-C.
    ASSERT_EQ(std::system(("bash -m -c '" + script + "'").c_str()), 0);
    EXPECT_EQ(lines_of(path("status")), std::vector<std::string>{"130"});
    EXPECT_EQ(lines_of(path("error")),
              std::vector<std::string>{"poolhall-lab: interrupted; what was finished is in " +
                                       path("out")});
    std::ifstream in(path("out") + "/accuracy.json");
    EXPECT_EQ(Json::parse(in)["complete"], false);
}

TEST_F(LabProgram, SaysThatItsOutputCannotBeWritten) {
    std::ofstream(path("scenes")) << line("a") << line("b");
    const auto status_of = [this](const std::string& command) {
        const int status = std::system((command + " 2>" + path("error")).c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    };
    const std::string simulate = POOLHALL_LAB " simulate " + path("scenes");
    EXPECT_EQ(status_of(simulate + " >/dev/full"), 2);
    EXPECT_EQ(lines_of(path("error")),
              std::vector<std::string>{"poolhall-lab: standard output cannot be written"});
    // A reader that goes at once; the status is the writer's.
    const std::string closed =
        "{ sleep 0.2; " + simulate + "; echo $? >" + path("status") + "; } | true";
    EXPECT_EQ(status_of(closed), 0);
    EXPECT_EQ(lines_of(path("status")), std::vector<std::string>{"2"});
    EXPECT_EQ(status_of(POOLHALL_LAB " hash >/dev/full"), 2);
}

TEST_F(LabProgram, AnswersALineBeforeTheNextOneComes) {
    // The second scene is sent only when the first result has come.
    const std::string script = "mkfifo " + path("to") + " && (" POOLHALL_LAB " simulate <" +
                               path("to") + " >" + path("out") + " &) && exec 3>" + path("to") +
                               " && cat " + path("scenes") +
                               " >&3 && for i in $(seq 100); do [ -s " + path("out") +
                               " ] && exit 0; sleep 0.1; done; exit 1";
    std::ofstream(path("scenes")) << line("a");
    EXPECT_EQ(std::system(script.c_str()), 0);
}

}  // namespace
}  // namespace poolhall::lab
