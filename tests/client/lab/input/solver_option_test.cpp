#include "client/lab/input/solver_option.hpp"

#include <gtest/gtest.h>

namespace poolhall::lab {
namespace {

TEST(SolverOption, ReadsKindsAndRates) {
    EXPECT_EQ(parse_solver("event"), (SolverSpec{SolverKind::kEvent, 30}));
    EXPECT_EQ(parse_solver("euler"), (SolverSpec{SolverKind::kEuler, 30}));
    EXPECT_EQ(parse_solver("euler:30"), (SolverSpec{SolverKind::kEuler, 30}));
    EXPECT_EQ(parse_solver("semi_implicit:120"), (SolverSpec{SolverKind::kSemiImplicit, 120}));
    EXPECT_EQ(parse_solver("exact_arc:7.5"), (SolverSpec{SolverKind::kExactArc, 7.5}));
    EXPECT_EQ(parse_solver("overlap:1e3"), (SolverSpec{SolverKind::kOverlap, 1000}));
}

TEST(SolverOption, RefusesWhatIsNone) {
    for (const char* text :
         {"", ":", "euler:", "euler:x", "euler:30x", "euler:0", "euler:-1", "euler:nan",
          "euler:inf", "euler:1e7", "rk4", "Euler", "event:30", "euler :30", "euler: 30"})
        EXPECT_FALSE(parse_solver(text)) << text;
}

}  // namespace
}  // namespace poolhall::lab
