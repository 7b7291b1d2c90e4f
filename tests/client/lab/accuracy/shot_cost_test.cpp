#include "client/lab/accuracy/shot_cost.hpp"

#include "client/lab/ensembles/ensembles.hpp"

#include <gtest/gtest.h>
#include <initializer_list>

namespace poolhall::lab {
namespace {

ShotTrace trace_of(std::initializer_list<double> times) {
    ShotTrace trace;
    for (const double t : times)
        trace.events.emplace_back().t = t;
    return trace;
}

TEST(Windows, AreA30thOfASecondOrATickIfThatIsLonger) {
    EXPECT_EQ(window_length({SolverKind::kEvent}), 1.0 / 30);
    EXPECT_EQ(window_length({SolverKind::kEuler, 480}), 1.0 / 30);
    EXPECT_EQ(window_length({SolverKind::kEuler, 15}), 1.0 / 15);
}

TEST(Windows, TheBusiestHasTheMostEventsOfAllShots) {
    const SolverSpec solver{SolverKind::kEuler, 10};
    Window busiest;
    note_busiest(trace_of({0, 0.05, 0.21, 0.22, 0.29, 0.31, 0.95}), solver, 4, busiest);
    EXPECT_EQ(busiest.shot, 4U);
    EXPECT_DOUBLE_EQ(busiest.begin, 0.2);
    EXPECT_DOUBLE_EQ(busiest.end, 0.3);
    EXPECT_EQ(busiest.events, 3U);
    note_busiest(trace_of({0.01, 0.02, 0.03}), solver, 5, busiest);
    EXPECT_EQ(busiest.shot, 4U);
    note_busiest(trace_of({0.01, 0.02, 0.03, 0.04}), solver, 6, busiest);
    EXPECT_EQ(busiest.shot, 6U);
    EXPECT_EQ(busiest.begin, 0);
}

TEST(Windows, EventsOnTheirEdgesAreCountedOnce) {
    // Times of ticks, some of them rounded to below the quotient that they are.
    ShotTrace trace;
    for (int k = 0; k < 3000; ++k)
        trace.events.emplace_back().t = k / 30.0;
    Window busiest;
    note_busiest(trace, {SolverKind::kEuler, 30}, 0, busiest);
    EXPECT_GE(busiest.events, 1U);
    EXPECT_LE(busiest.events, 2U);
}

TEST(ShotCost, TicksCostTime) {
    const auto shots = scenes_of(*find_ensemble("one_ball"), 1, 3);
    const Repeats repeats{3, 1e6};
    const SolverSpec slow{SolverKind::kEuler, 1920};
    const SolverSpec fast{SolverKind::kEuler, 30};
    const Window first{0, 0, 1.0 / 30, 1};
    const ShotCost much = cost_of_shots(shots, slow, 1e5, first, repeats);
    const ShotCost little = cost_of_shots(shots, fast, 1e4, first, repeats);
    EXPECT_GT(little.ns, 0);
    EXPECT_GT(much.ns, 3 * little.ns);
    EXPECT_GT(much.worst_tick_ns, 0);
    EXPECT_LT(much.worst_tick_ns, much.ns);
}

}  // namespace
}  // namespace poolhall::lab
