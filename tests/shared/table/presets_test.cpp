#include "shared/table/presets.hpp"

#include "shared/physics/check.hpp"
#include "shared/physics/effects/presets.hpp"
#include "shared/table/pool_table.hpp"

#include <gtest/gtest.h>

namespace poolhall {
namespace {

constexpr double kInch = 0.0254;

/// The balls that are played on a table.
BallSet balls_of(TablePreset table) {
    if (table == TablePreset::kTwelveFootSnooker) return BallSet::kSnooker;
    return table == TablePreset::kTenFootCarom ? BallSet::kCarom : BallSet::kWpa;
}

EffectsPreset effects_of(TablePreset table) {
    if (table == TablePreset::kTwelveFootSnooker) return EffectsPreset::kSnooker;
    return table == TablePreset::kTenFootCarom ? EffectsPreset::kHeatedCarom
                                               : EffectsPreset::kWorsted;
}

TEST(Presets, AreGoodScenesEachWithItsBallsAndCloth) {
    for (const TablePreset table : kValues<TablePreset>) {
        Scene scene;
        scene.table = preset_value(table);
        scene.ball = preset_value(balls_of(table));
        scene.effects = preset_value(effects_of(table));
        scene.solver.kind = SolverKind::kEvent;
        scene.balls = {{"cue", {}}};
        scene.strike = Strike{};
        scene.strike->cue = preset_value(CuePreset::kPlain);
        const auto error = check(scene);
        EXPECT_FALSE(error) << name(table) << " " << error->pointer << " " << error->reason;
    }
}

TEST(Presets, OfABarTableFitItsLargeCueBall) {
    const Table bar = preset_value(TablePreset::kSevenFootBar);
    for (const BallSet set : {BallSet::kBarHeavy, BallSet::kBarLarge}) {
        ASSERT_TRUE(cue_ball_of(set));
        EXPECT_TRUE(fits_pool_table(bar, cue_ball_of(set)->radius));
        EXPECT_GT(cue_ball_of(set)->mass, preset_value(set).mass);
    }
    EXPECT_GT(cue_ball_of(BallSet::kBarLarge)->radius, preset_value(BallSet::kBarLarge).radius);
    EXPECT_FALSE(cue_ball_of(BallSet::kWpa));
}

TEST(Presets, AreTwiceAsLongAsWideButForSnooker) {
    for (const TablePreset preset : kValues<TablePreset>) {
        const Table table = preset_value(preset);
        if (preset == TablePreset::kTwelveFootSnooker) continue;
        EXPECT_NEAR(2 * table.width, table.length, 1e-12) << name(preset);
    }
}

TEST(Presets, TheTournamentTableHasTheTightMouthsOfProfessionals) {
    const Table table = preset_value(TablePreset::kNineFootPro);
    EXPECT_EQ(4.25 * kInch, table.mouths->corner.width);
    EXPECT_EQ(kCornerMouth.jaw_radius, table.mouths->corner.jaw_radius);
}

/// How far from a nose line the rubber of the jaw next to it is, at most.
TEST(Presets, JawsOfASnookerTableAreRound) {
    const PoolTable snooker(preset_value(TablePreset::kTwelveFootSnooker));
    const PoolTable pool(preset_value(TablePreset::kNineFoot));
    for (std::size_t i = 0; i < snooker.arcs().size(); ++i)
        EXPECT_GT(snooker.arcs()[i].radius, 10 * pool.arcs()[i].radius);
}

TEST(Presets, MouthsOfOnesOwnAreRefusedWhereABallCouldLeaveTheTable) {
    const auto fault_with = [](auto change) {
        Table table;
        change(table.mouths.emplace());
        const auto fault = fault_of_mouths(table);
        return fault ? std::string(fault->pointer) : "";
    };
    EXPECT_EQ("", fault_with([](Mouths&) {}));
    EXPECT_EQ("", fault_with([](Mouths& m) { m.corner.jaw_radius = 0.02095; }));
    EXPECT_EQ("", fault_with([](Mouths& m) { m.side.facing = {1, 4}; }));
    EXPECT_EQ("/mouths/corner", fault_with([](Mouths& m) { m.corner.facing = {1, 0}; }));
    EXPECT_EQ("/mouths/side", fault_with([](Mouths& m) { m.side.facing = {-0.1, 1}; }));
    EXPECT_EQ("/mouths/side", fault_with([](Mouths& m) { m.side.jaw_radius = 0.08; }));
    EXPECT_EQ("/mouths/corner", fault_with([](Mouths& m) { m.corner.hole_radius = 0.03; }));
    EXPECT_EQ("/mouths/corner", fault_with([](Mouths& m) { m.corner.shelf = 0.2; }));
    EXPECT_EQ("/mouths/side", fault_with([](Mouths& m) { m.side.width = 0.2; }));
}

}  // namespace
}  // namespace poolhall
