#include "tests/e2e/table.hpp"

#include "shared/analysis/effect_use.hpp"
#include "shared/game/end_game.hpp"
#include "shared/physics/simulate.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>

namespace poolhall::e2e {

using namespace protocol;

namespace {

constexpr int kDirections = 1440;
/// Frames show positions to 10 um (JSON) or in single precision (CBOR), m.
constexpr double kFrameTolerance = 1e-5;

/// Every frame shows the balls where the simulation has them at its tick.
void expect_frames(const std::vector<Frame>& frames, const ShotTrace& trace) {
    std::uint32_t tick = 0;
    for (const Frame& frame : frames) {
        ASSERT_GT(frame.tick, tick);
        ASSERT_LT(frame.tick, trace.sample_count());
        tick = frame.tick;
        for (const Frame::Ball& ball : frame.balls) {
            const Vec2 exact = xy(trace.sample(tick, ball.ball.value));
            EXPECT_NEAR(ball.r.x, exact.x, kFrameTolerance) << "tick " << tick;
            EXPECT_NEAR(ball.r.y, exact.y, kFrameTolerance) << "tick " << tick;
        }
    }
    EXPECT_EQ(tick + 1, trace.sample_count());
}

std::vector<ShotEvent> events_of(const std::vector<Frame>& frames) {
    std::vector<ShotEvent> events;
    for (const Frame& frame : frames)
        events.insert(events.end(), frame.events.begin(), frame.events.end());
    return events;
}

}  // namespace

MakeMove shot_by(Seat seat, Vec2 direction) {
    Shoot move;
    move.strike.direction = direction;
    return {seat, move};
}

MakeMove rematch_by(Seat seat) {
    return {seat, Agree{Accord::kRematch}};
}

PlayedShot find_shot(const GameState& game, Verdict verdict) {
    std::optional<PlayedShot> best;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = 2 * std::numbers::pi * i / kDirections;
        PlayedShot outcome = test::shoot(kEndGameRules, game, {std::cos(angle), std::sin(angle)});
        if (outcome.ruling.verdict != verdict) continue;
        if (!best || outcome.trace.duration < best->trace.duration) best = std::move(outcome);
    }
    if (!best) throw std::runtime_error("no shot gets the verdict " + std::string(name(verdict)));
    return *std::move(best);
}

MakeMove command_of(const PlayedShot& outcome) {
    return shot_by(outcome.ruling.shooter, outcome.scene.strike.value().direction);
}

Duel::Duel(std::uint16_t port, Encoding ann_speaks, Encoding bob_speaks,
           const MatchSettings& settings)
    : ann(port, ann_speaks),
      bob(port, bob_speaks),
      ann_joined(ann.enter(CreateMatch{"Ann", "end_game", Stream::kStates, settings})),
      bob_joined(bob.enter(JoinMatch{ann_joined.table.code, "Bob"})),
      game(new_game(kEndGameRules, bob_joined.table.state.turn, settings.game)) {
    EXPECT_EQ(bob_joined.table.phase, Phase::kAiming);
    EXPECT_EQ(bob_joined.table.state, game);
    ann.await_table([](const TableState& table) { return table.phase == Phase::kAiming; });
}

PlayedShot Duel::play(Verdict verdict) {
    PlayedShot outcome = find_shot(game, verdict);
    player(game.turn).send(command_of(outcome));
    expect_same_shot(ann.hear_shot(), outcome);
    expect_same_shot(bob.hear_shot(), outcome);
    game = outcome.state;
    return outcome;
}

void expect_same_shot(const ShotHeard& heard, const PlayedShot& outcome) {
    EXPECT_EQ(heard.started.seat, outcome.ruling.shooter);
    EXPECT_EQ(heard.started.scene, outcome.scene);
    EXPECT_EQ(heard.started.scene_hash, hash_of(outcome.scene));
    expect_frames(heard.frames, outcome.trace);
    EXPECT_EQ(events_of(heard.frames), outcome.trace.events);

    const ShotEnded& ended = heard.ended;
    EXPECT_EQ(ended.shot, heard.started.shot);
    EXPECT_EQ(ended.hash, outcome.trace.hash);
    EXPECT_EQ(ended.balls, outcome.trace.balls);
    EXPECT_EQ(ended.duration, outcome.trace.duration);
    EXPECT_EQ(ended.kernel, outcome.trace.kernel);
    EXPECT_EQ(ended.effects, analysis::effect_uses(outcome.scene, outcome.trace));
    EXPECT_EQ(ended.solver, outcome.trace.solver);
    EXPECT_EQ(ended.outcome, Outcome::kRest);
    EXPECT_EQ(ended.ruling, outcome.ruling);
    expect_table_after(ended.table, outcome);
}

void expect_table_after(const TableState& table, const PlayedShot& outcome) {
    EXPECT_EQ(table.state, outcome.state);
    EXPECT_EQ(table.legal, kEndGameRules.legal(outcome.state));
    EXPECT_EQ(table.phase, outcome.state.over ? Phase::kOver : Phase::kAiming);
    EXPECT_EQ(table.ruling, outcome.ruling);
    EXPECT_FALSE(table.cue.has_value());
    EXPECT_FALSE(table.live.has_value());
}

}  // namespace poolhall::e2e
