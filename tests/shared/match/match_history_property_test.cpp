#include "tests/shared/match/matches.hpp"
#include "tests/shared/random.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace poolhall {
namespace {

using namespace test;
using testing::Random;

MatchSettings random_settings(Random& random) {
    MatchSettings settings;
    settings.race_to = static_cast<std::uint32_t>(random.below(4));
    settings.breaks = static_cast<BreakOrder>(random.below(3));
    settings.turns = static_cast<Turns>(random.below(2));
    if (random.below(2) == 0) settings.shot_clock_s = 30;
    if (random.below(4) == 0) settings.game.solver = SolverSpec{SolverKind::kEvent, 30};
    return settings;
}

/// Any move at all, legal or not.
Move random_move(Random& random) {
    switch (random.below(12)) {
        case 0:
            return Concede{};
        case 1:
        case 2:
            return Agree{};
        case 3:
            return TimeOut{};
        case 4:
        case 5:
            return Place{{end_game::kBaseLineX, random.uniform(-0.4, 0.4)}};
        default:
            break;
    }
    return shot(random.direction());
}

/// A match that is played, and what was seen of it on the way.
struct Seen {
    explicit Seen(const MatchSpec& spec) : match(spec), positions{match.now()} {}

    Match match;
    std::vector<Position> positions;    ///< after so many moves
    std::vector<std::uint64_t> traces;  ///< of each move's shot; 0 if it was none

    void take(MatchStep step, std::int64_t at_ms) {
        traces.push_back(step.shot() ? step.shot()->simulated.trace.hash : 0);
        match.commit(std::move(step), at_ms);
        positions.push_back(match.now());
    }

    void reset(Seat seat) {
        match.reset_seat(seat);
        positions.back() = match.now();
    }
};

/// Tries moves until `count` have been taken; those that are refused change nothing.
Seen play(std::uint64_t seed, std::size_t count) {
    Random random(seed);
    const MatchSettings settings = random_settings(random);
    Seen seen(end_game_match(settings, Seat{static_cast<std::uint8_t>(random.below(2))}));
    std::int64_t now = kNow;
    seen.match.start_clock(now);
    while (seen.traces.size() < count) {
        now += static_cast<std::int64_t>(random.below(40'000));
        const Seat seat{static_cast<std::uint8_t>(random.below(2))};
        if (random.below(20) == 0) seen.reset(seat);
        const Move move = random_move(random);
        const Position before = seen.match.now();
        const bool refused = seen.match.find_fault(seat, move, now).has_value();
        if (!refused) {
            const MatchStep step = seen.match.play(seat, move, now);
            EXPECT_EQ(before, seen.match.now()) << "playing changes nothing";
            seen.take(step, now);
        } else {
            EXPECT_EQ(before, seen.match.now());
        }
    }
    return seen;
}

TEST(MatchHistory, GivesEveryPositionAndStepAgainInAnyOrder) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Seen seen = play(seed, 20 + 3 * seed);
        Random order(seed);
        for (std::size_t look = 0; look < 2 * seen.positions.size(); ++look) {
            const std::size_t count = order.below(seen.positions.size());
            ASSERT_EQ(seen.positions[count], seen.match.at(count)) << seed << " " << count;
        }
        for (std::size_t i = seen.traces.size(); i-- > 0;) {
            const MatchStep step = seen.match.step(i);
            ASSERT_EQ(seen.match.moves()[i], step.made) << seed << " " << i;
            const std::uint64_t trace = step.shot() ? step.shot()->simulated.trace.hash : 0;
            ASSERT_EQ(seen.traces[i], trace) << seed << " " << i;
        }
    }
}

TEST(MatchHistory, IsTheSameForTheSameMoves) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Seen one = play(seed, 40);
        const Seen other = play(seed, 40);
        ASSERT_EQ(one.positions, other.positions);
        ASSERT_EQ(one.match.moves(), other.match.moves());
    }
}

TEST(MatchPositions, CountShotsAndWinsAndAgreeWithTheRules) {
    for (std::uint64_t seed = 100; seed < 130; ++seed) {
        const Seen seen = play(seed, 60);
        for (std::size_t i = 1; i < seen.positions.size(); ++i) {
            const Position& before = seen.positions[i - 1];
            const Position& now = seen.positions[i];
            ASSERT_EQ(kEndGameRules.legal(now.game), now.legal);
            ASSERT_EQ(before.shots + (seen.traces[i - 1] != 0 ? 1 : 0), now.shots);
            ASSERT_EQ(hash_of(now.game), seen.match.moves()[i - 1].state);
            const std::uint32_t race = seen.match.settings().race_to;
            ASSERT_TRUE(!now.winner || race > 0);
            const bool solo = seen.match.settings().turns == Turns::kSolo && !now.game.over;
            ASSERT_TRUE(!solo || now.legal.seat == Seat{0});
        }
    }
}

}  // namespace
}  // namespace poolhall
