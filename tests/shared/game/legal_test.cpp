#include "shared/game/legal.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace poolhall {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A game in which the player has a choice of everything.
Legal free_legal() {
    Legal legal;
    legal.place = Region{{-1, -0.5}, {-0.5, 0.5}};
    legal.shoot = StrokeBounds{0.5, 10, 4, 0.6, 2};
    return legal;
}

std::optional<IllegalMove> fault_of(const Stroke& stroke) {
    return find_fault(free_legal(), Shoot{stroke});
}

IllegalMove out_of_bounds(std::string_view field) {
    return {Illegal::kOutOfBounds, field};
}

TEST(LegalMoves, StrokeMayBeAnythingWithinTheBoundsEdgesIncluded) {
    for (const Stroke& stroke : {Stroke{{0, -1}, {}, {}, 0}, Stroke{{1, 0}, 0.5, {0.6, 0}, 2},
                                 Stroke{{1, 0}, 10.0, {0.36, 0.48}, 1}})
        EXPECT_FALSE(fault_of(stroke));
}

TEST(LegalMoves, StrokeBeyondABoundIsBlamedOnItsField) {
    for (const double speed : {0.499, 10.001, -1.0, kNan})
        EXPECT_EQ(out_of_bounds("/strike/speed"), fault_of({{1, 0}, speed, {}, 0}));
    for (const Vec2 offset : {Vec2{0.601, 0}, Vec2{0.5, 0.5}, Vec2{kNan, 0}, Vec2{0, kNan}})
        EXPECT_EQ(out_of_bounds("/strike/offset"), fault_of({{1, 0}, {}, offset, 0}));
    for (const double elevation : {-0.001, 2.001, kNan})
        EXPECT_EQ(out_of_bounds("/strike/elevation"), fault_of({{1, 0}, {}, {}, elevation}));
    EXPECT_EQ((IllegalMove{Illegal::kBadDirection, "/strike/direction"}),
              fault_of({{0, 0}, 99.0, {9, 9}, 99}))
        << "the first fault in the order of the fields";
}

TEST(LegalMoves, WhatIsNotOfferedIsRefusedWhateverItAsks) {
    const Legal nothing;
    EXPECT_EQ((IllegalMove{Illegal::kNotOffered, ""}), find_fault(nothing, Shoot{}));
    EXPECT_EQ((IllegalMove{Illegal::kNotOffered, ""}), find_fault(nothing, Place{}));
}

TEST(LegalMoves, PlaceMayBeAMicrometreOutsideItsRegion) {
    const Legal legal = free_legal();
    for (const Vec2 inside : {Vec2{-1, -0.5}, Vec2{-0.5, 0.5}, Vec2{-0.7, 0.1},
                              Vec2{-1 - 0.9e-6, 0}, Vec2{-0.7, 0.5 + 0.9e-6}})
        EXPECT_FALSE(find_fault(legal, Place{inside}));
    for (const Vec2 outside : {Vec2{-1 - 1.1e-6, 0}, Vec2{-0.7, 0.5 + 1.1e-6}, Vec2{kNan, 0}})
        EXPECT_EQ((IllegalMove{Illegal::kOutOfRegion, "/position"}),
                  find_fault(legal, Place{outside}));
}

TEST(CompletedMoves, HaveTheGamesSpeedWhereTheyNameNone) {
    const Legal legal = free_legal();
    const Stroke open{{1, 2}, {}, {0.1, 0.2}, 0.5};
    EXPECT_EQ((Move{Shoot{{{1, 2}, 4.0, {0.1, 0.2}, 0.5}}}), completed(legal, Shoot{open}));
    const Move named = Shoot{{{1, 2}, 5.0, {}, 0}};
    EXPECT_EQ(named, completed(legal, named));
}

TEST(CompletedMoves, HaveAPlaceWithinTheRegion) {
    EXPECT_EQ((Move{Place{{-1, 0.5}}}), completed(free_legal(), Place{{-1 - 1e-7, 0.5 + 1e-7}}));
    EXPECT_EQ((Move{Place{{-0.7, 0.1}}}), completed(free_legal(), Place{{-0.7, 0.1}}));
}

TEST(CompletedMoves, AreCompleteAlready) {
    const Legal legal = free_legal();
    for (const Move& move :
         {Move{Shoot{}}, Move{Place{{-2, 3}}}, Move{Concede{}}, Move{Agree{}}, Move{TimeOut{}}}) {
        const Move once = completed(legal, move);
        EXPECT_EQ(once, completed(legal, once));
    }
}

}  // namespace
}  // namespace poolhall
