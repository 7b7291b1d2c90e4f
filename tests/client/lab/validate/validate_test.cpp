#include "client/lab/validate/cases.hpp"
#include "client/lab/validate/diamonds.hpp"
#include "client/lab/validate/models.hpp"
#include "client/lab/validate/tables.hpp"
#include "client/lab/validate/validate_command.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace poolhall::lab {
namespace {

using nlohmann::json;

const MeasuredTable& named(const std::vector<MeasuredTable>& tables, const std::string& name) {
    const auto found = std::find_if(tables.begin(), tables.end(),
                                    [&](const MeasuredTable& table) { return table.name == name; });
    EXPECT_NE(tables.end(), found) << name;
    return *found;
}

TEST(MeasuredTable, ErrorIsZeroWithinARangeAndFromItsNearerEndOutside) {
    MeasuredTable table;
    table.models = {"a", "b", "c", "d"};
    const MeasuredRow row{"", {7, 9}, false, {8.0, 6.5, 10.0, std::nullopt}};
    EXPECT_EQ(0, error_of(table, row, 0));
    EXPECT_EQ(-0.5, error_of(table, row, 1));
    EXPECT_EQ(1, error_of(table, row, 2));
    EXPECT_FALSE(error_of(table, row, 3));
}

TEST(MeasuredTable, RmsIsWithAndWithoutOutliersAndLeavesOutWhatDoesNotApply) {
    MeasuredTable table;
    table.is_relative = true;
    table.models = {"a", "b"};
    table.rows = {{"", 2.0, false, {2.2, std::nullopt}}, {"", 1.0, true, {0.5, std::nullopt}}};
    const TableErrors errors = errors_of(table, 0);
    EXPECT_NEAR(std::sqrt((0.01 + 0.25) / 2), errors.rms.value(), 1e-12);
    EXPECT_NEAR(0.1, errors.rms_without_outliers.value(), 1e-12);
    EXPECT_FALSE(errors_of(table, 1).rms);
}

// Alciatore's formulas, to the digits that are printed.
TEST(Validate, PublishedFormulasAreMetToAThousandthOfADegree) {
    const auto tables = worked_value_tables();
    const MeasuredTable& angles = named(tables, "worked_angles");
    EXPECT_EQ(35U, angles.rows.size());
    for (const MeasuredRow& row : angles.rows)
        EXPECT_LT(std::abs(error_of(angles, row, 0).value()), 0.001) << row.what;
    const MeasuredTable& speed = named(tables, "worked_speed");
    EXPECT_LT(std::abs(error_of(speed, speed.rows[0], 0).value()), 1e-4);
}

// Theirs by elastic impacts: Am. J. Phys. 77, 788, table I, "theoretical".
TEST(Validate, FilmedShotsOfElasticBallsAreThoseOfTheirSource) {
    const auto tables = two_ball_tables();
    const MeasuredTable& speeds = named(tables, "two_balls_speed");
    ASSERT_EQ("elastic", speeds.models[0]);
    EXPECT_NEAR(0.0749, errors_of(speeds, 0).rms.value(), 5e-4);
    EXPECT_NEAR(0.0633, errors_of(speeds, 0).rms_without_outliers.value(), 5e-4);
}

TEST(Validate, SquareReboundOfMathavansRailHasThePublishedSlope) {
    const NoseModel mathavan = snooker_noses()[1];
    const RailOutcome out = just_after({.ball = kSnookerBall, .rail = mathavan.rail});
    EXPECT_NEAR(0.911, out.speed, 0.004);
    EXPECT_NEAR(0, out.angle, 1e-12);
}

TEST(Validate, ObjectBallLeavesByTheAngleThatIsAskedFor) {
    TwoBallCase one{.ball = kSnookerBall, .impact = with_alciatores_law(0.95), .speed = 1.5};
    one = with_object_angle(one, -40 * kDegree);
    EXPECT_NEAR(-40 * kDegree, just_after(one).object_angle, 1e-9);
    EXPECT_GT(one.cut, 40 * kDegree);
}

TEST(Diamonds, MirrorOfAKickIsFartherBehindTheNoseForAMoreObliqueBall) {
    const RailSpec rail = pool_noses()[0].rail;
    EXPECT_GT(mirror_depth(rail, 60 * kDegree), mirror_depth(rail, 30 * kDegree));
}

TEST(Diamonds, LineThatMissesAnyOfItsThreeRailsHasNoThirdRail) {
    EXPECT_FALSE(third_rail(pool_noses()[0].rail, {5, -2}, 0));
    EXPECT_TRUE(third_rail(pool_noses()[0].rail, {5, 3}, 0));
}

TEST(Diamonds, FasterBallGoesMoreLengths) {
    const RailSpec rail = pool_noses()[0].rail;
    EXPECT_LT(speed_for_lengths(rail, 2), speed_for_lengths(rail, 4));
}

class ValidateCommand : public ::testing::Test {
  protected:
    ValidateCommand()
        : folder(std::filesystem::path(::testing::TempDir()) /
                 ("validate_" +
                  std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        std::filesystem::remove_all(folder);
    }

    ~ValidateCommand() override { std::filesystem::remove_all(folder); }

    std::filesystem::path folder;
    std::ostringstream out;
    std::ostringstream error;
};

TEST_F(ValidateCommand, WritesEveryTableWithItsSourceAndAnErrorForEachModel) {
    ASSERT_EQ(Status::kGood, validate({.out = folder.string()}, out, error)) << error.str();
    const json result = json::parse(std::ifstream(folder / "validate.json"));
    EXPECT_EQ("poolhall.validate/1", result["schema"]);
    EXPECT_EQ(true, result["complete"]);
    ASSERT_GT(result["tables"].size(), 15U);
    for (const json& table : result["tables"]) {
        EXPECT_NE("", table["source"]) << table["name"];
        EXPECT_NE(std::string::npos, out.str().find(table["title"].get<std::string>()));
        for (const json& row : table["rows"]) {
            EXPECT_EQ(table["models"].size(), row["ours"].size()) << row;
            EXPECT_EQ(table["models"].size(), row["errors"].size()) << row;
        }
    }
    ASSERT_EQ(5U, result["figures"].size());
    for (const json& figure : result["figures"]) {
        for (const json& curve : figure["curves"])
            EXPECT_EQ(curve["x"].size(), curve["y"].size()) << figure["name"];
    }
    std::ifstream csv(folder / "validate.csv");
    std::string head;
    std::getline(csv, head);
    EXPECT_EQ("table,row,unit,model,published_low,published_high,ours,error,outlier", head);
}

TEST_F(ValidateCommand, FitsRecordedShotsByModel) {
    std::vector<RecordedModel> models = recorded_models(2);
    models.resize(1);
    models[0].plan.first = models[0].plan.last = {30, 6, 1};
    models[0].plan.evaluations = 10;
    models[0].plan.rounds = 1;
    const ValidateOptions options{folder.string(), POOLHALL_MADE_UP_SHOTS, 2};
    ASSERT_EQ(Status::kGood, validate(options, models, out, error)) << error.str();
    const json result = json::parse(std::ifstream(folder / "validate.json"));
    EXPECT_EQ(4, result["recorded_shots"]);
    ASSERT_EQ(1U, result["recorded"].size());
    const json& found = result["recorded"][0];
    EXPECT_EQ(2, found["odd"]["shots"]);
    EXPECT_EQ(2, found["even"]["shots"]);
    EXPECT_LE(found["even"]["whole"]["p25"], found["even"]["whole"]["p75"]);
    EXPECT_TRUE(found["constants"].contains("rail e")) << found;
    EXPECT_NE(std::string::npos, out.str().find("cue ball to its third rail"));
}

TEST_F(ValidateCommand, SaysAtOnceWhatIsNoRecording) {
    std::filesystem::create_directories(folder);
    const std::string file = (folder / "shots.json").string();
    std::ofstream(file) << "[{\"balls\": {}},\n{\"balls\": {}}]";
    EXPECT_EQ(Status::kBadInput, validate({.recorded = file}, out, error));
    EXPECT_EQ("poolhall-lab: " + file + ": /0/balls: must be 1 to 16 balls\n", error.str());
    EXPECT_EQ("", out.str());
}

TEST_F(ValidateCommand, SaysAtOnceThatTheFolderCannotBeMade) {
    std::ofstream(folder.string()) << "a file";
    EXPECT_EQ(Status::kBadInput, validate({.out = (folder / "under").string()}, out, error));
    EXPECT_NE(std::string::npos, error.str().find(folder.string())) << error.str();
    EXPECT_EQ("", out.str());
}

}  // namespace
}  // namespace poolhall::lab
