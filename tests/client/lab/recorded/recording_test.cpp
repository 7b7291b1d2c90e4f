#include "client/lab/recorded/recording.hpp"

#include <gtest/gtest.h>

namespace poolhall::lab {
namespace {

const std::string kShot =
    R"({"id": 7, "balls": {"1": {"t": [0, 3], "x": [0.5, 0.5], "y": [0, 0]},)"
    R"( "2": {"t": [0, 0.02, 0.04], "x": [-0.5, -0.45, -0.4], "y": [0.1, 0.1, 0.1]}}})";

std::string fault_of(const std::string& text) {
    const auto shots = parse_recording(text);
    return shots ? "" : shots.error();
}

TEST(Recording, HasABallATrackAndTheCueBallIsTheFirstThatMoves) {
    const auto shots = parse_recording("[" + kShot + "," + kShot + "]");
    ASSERT_TRUE(shots) << shots.error();
    ASSERT_EQ(2U, shots->size());
    EXPECT_EQ("7", (*shots)[0].id);
    ASSERT_EQ(2U, (*shots)[0].tracks.size());
    EXPECT_EQ(1U, (*shots)[0].cue);
    EXPECT_EQ((Vec2{-0.45, 0.1}), (*shots)[0].tracks[1].r[1]);
}

TEST(Recording, SyntaxErrorIsSaidWithItsLine) {
    EXPECT_EQ("line 2: a syntax error", fault_of("[" + kShot + ",\n{]"));
}

TEST(Recording, WhatIsWrongIsSaidWithItsPointer) {
    const auto with = [](const std::string& track) {
        return "[" + kShot + R"(, {"balls": {"a": )" + track + "}}]";
    };
    EXPECT_EQ("must be a JSON array of two shots or more", fault_of("[" + kShot + "]"));
    EXPECT_EQ("/1: must be an object with \"balls\"", fault_of("[" + kShot + ", 3]"));
    EXPECT_EQ("/1/balls/a: has no \"y\"", fault_of(with(R"({"t": [0], "x": [0]})")));
    EXPECT_EQ("/1/balls/a/x: must be as long as \"t\"",
              fault_of(with(R"({"t": [0, 1], "x": [0], "y": [0]})")));
    EXPECT_EQ("/1/balls/a/x/0: must be a number up to 1.4400 in size",
              fault_of(with(R"({"t": [0], "x": [2], "y": [0]})")));
    EXPECT_EQ("/1/balls/a/x/0: must be a number up to 1.4400 in size",
              fault_of(with(R"({"t": [0], "x": [null], "y": [0]})")));
    EXPECT_EQ("/1/balls/a/t: must ascend from 0",
              fault_of(with(R"({"t": [1, 0], "x": [0, 0], "y": [0, 0]})")));
    EXPECT_EQ("/1/balls: none of them moves",
              fault_of(with(R"({"t": [0, 1], "x": [0, 0], "y": [0, 0]})")));
}

TEST(Recording, FileThatIsNotThereIsSaidByItsName) {
    const auto shots = read_recording("/nowhere/shots.json");
    ASSERT_FALSE(shots);
    EXPECT_EQ("/nowhere/shots.json: cannot be read", shots.error());
}

}  // namespace
}  // namespace poolhall::lab
