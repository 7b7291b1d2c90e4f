#include "shared/game/end_game.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/shared/random.hpp"

#include <gtest/gtest.h>
#include <optional>
#include <vector>

// What holds in every game, whatever is played.
namespace poolhall {
namespace {

using testing::Random;

/// A move that the rules offer: mostly shots, now and then a placement or a clock that runs down.
Move random_move(const Legal& legal, Random& random) {
    const std::size_t kind = random.below(8);
    if (legal.place && kind < 4) {
        const Region& region = *legal.place;
        return Place{{random.uniform(region.low.x, region.high.x),
                      random.uniform(region.low.y, region.high.y)}};
    }
    if (kind == 7) return TimeOut{};
    Shoot shot;
    shot.strike.direction = random.direction();
    if (random.below(2) == 0) shot.strike.speed = legal.shoot->own_speed;
    return shot;
}

/// Moves that the rules must refuse in this state.
std::vector<Move> illegal_moves(const Legal& legal) {
    std::vector<Move> moves{Shoot{{{0, 0}, {}, {}, 0}}, Place{{99, 0}}};
    const double too_fast = legal.shoot ? legal.shoot->max_speed * 1.01 : 1.0;
    moves.emplace_back(Shoot{{{1, 0}, too_fast, {}, 0}});
    moves.emplace_back(Shoot{{{1, 0}, {}, {1, 1}, 0}});
    moves.emplace_back(Shoot{{{1, 0}, {}, {}, 99}});
    if (!legal.place) moves.emplace_back(Place{{end_game::kBaseLineX, 0}});
    if (!legal.shoot) moves.emplace_back(Shoot{});
    return moves;
}

/// The state is one that anybody can go on from, and what is legal in it agrees with it.
void expect_whole(const Ruleset& rules, const GameState& state) {
    const auto error = check(state.scene);
    ASSERT_FALSE(error) << error->pointer << " " << error->reason;
    ASSERT_FALSE(state.scene.strike);
    ASSERT_LT(state.cue_ball.value, state.scene.balls.size());
    ASSERT_EQ("cue", state.scene.balls[state.cue_ball.value].id);
    ASSERT_EQ(state.over, state.winner.has_value());
    for (const SceneBall& ball : state.scene.balls) {
        ASSERT_EQ(Vec3{}, ball.state.v);
        ASSERT_EQ(Vec3{}, ball.state.w);
    }
    const Legal legal = rules.legal(state);
    ASSERT_EQ(state.turn, legal.seat);
    ASSERT_EQ(state.over, !legal.shoot.has_value());
    ASSERT_NE(Vec2{}, legal.aim);
    for (const Move& move : illegal_moves(legal))
        ASSERT_TRUE(find_fault(legal, move));
}

/// What a move did agrees with itself.
void expect_consistent(const GameState& before, const Move& move, const Turn& turn) {
    const bool shot = std::holds_alternative<Shoot>(move);
    ASSERT_EQ(shot, turn.shot.has_value());
    ASSERT_EQ(std::holds_alternative<Place>(move), !turn.ruling.has_value());
    ASSERT_EQ(before.shots + (shot ? 1 : 0), turn.state.shots);
    if (!turn.ruling) return;
    ASSERT_EQ(before.turn, turn.ruling->shooter);
    ASSERT_EQ(turn.state.winner, turn.ruling->winner);
    ASSERT_TRUE(turn.state.over || turn.ruling->next == turn.state.turn);
    if (!shot) return;
    ASSERT_EQ(turn.shot->trace.hash, simulate(turn.shot->scene).hash);
    ASSERT_LE(turn.ruling->decided_at, turn.shot->trace.duration);
}

/// Plays a random game to its end; the hash of each state on the way.
std::vector<std::uint64_t> play_game(const Ruleset& rules, std::uint64_t seed) {
    Random random(seed);
    GameState state = rules.new_game(Seat{static_cast<std::uint8_t>(random.below(2))});
    std::vector<std::uint64_t> hashes;
    while (!state.over && hashes.size() < 2000) {
        const GameState before = state;
        const Legal legal = rules.legal(state);
        const Move move = random_move(legal, random);
        EXPECT_FALSE(find_fault(legal, move));
        const Turn turn = rules.play(state, completed(legal, move));
        EXPECT_EQ(before, state);
        expect_consistent(before, move, turn);
        expect_whole(rules, turn.state);
        if (::testing::Test::HasFatalFailure()) return hashes;
        state = turn.state;
        hashes.push_back(hash_of(state));
    }
    EXPECT_TRUE(state.over);
    return hashes;
}

TEST(EveryGame, IsPlayedToItsEndByLegalMovesThroughWholeStates) {
    for (const Ruleset* rules : all_rulesets()) {
        for (std::uint64_t seed = 0; seed < 3000; ++seed) {
            play_game(*rules, seed);
            ASSERT_FALSE(HasFailure()) << rules->name << " " << seed;
        }
    }
}

TEST(EveryGame, GivesTheSameStatesForTheSameMoves) {
    for (const Ruleset* rules : all_rulesets()) {
        for (std::uint64_t seed = 0; seed < 50; ++seed)
            ASSERT_EQ(play_game(*rules, seed), play_game(*rules, seed));
    }
}

}  // namespace
}  // namespace poolhall
