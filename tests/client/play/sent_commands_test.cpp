#include "client/play/sent_commands.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

using protocol::Aim;
using protocol::Ping;

TEST(SentCommands, NumbersRiseFromOneOnEveryConnection) {
    SentCommands sent;
    EXPECT_EQ(sent.number(Ping{}).seq, 1U);
    EXPECT_EQ(sent.add(Aim{Seat{0}, {1, 0}}).seq, 2U);
    sent.restart();
    EXPECT_EQ(sent.number(Ping{}).seq, 1U);
}

TEST(SentCommands, AnswerFindsItsCommandOnce) {
    SentCommands sent;
    const auto first = sent.add(Aim{Seat{0}, {1, 0}});
    const auto second = sent.add(Aim{Seat{0}, {0, 1}});
    EXPECT_EQ(sent.take(second.seq), second.body);
    EXPECT_EQ(sent.take(first.seq), first.body);
    EXPECT_EQ(sent.take(first.seq), std::nullopt);
}

TEST(SentCommands, WhatIsOfNoInterestOrOfAnOldConnectionHasNoCommand) {
    SentCommands sent;
    EXPECT_EQ(sent.take(sent.number(Ping{}).seq), std::nullopt);
    const auto command = sent.add(Aim{Seat{0}, {1, 0}});
    sent.restart();
    EXPECT_EQ(sent.take(command.seq), std::nullopt);
}

TEST(SentCommands, ServerThatNeverAnswersCostsNoMemory) {
    SentCommands sent;
    const auto first = sent.add(Aim{Seat{0}, {1, 0}});
    for (std::size_t i = 0; i < SentCommands::kMaxUnanswered; ++i)
        static_cast<void>(sent.add(Aim{Seat{0}, {0, 1}}));
    EXPECT_EQ(sent.take(first.seq), std::nullopt);
    EXPECT_TRUE(sent.take(first.seq + 1));
}

}  // namespace
}  // namespace poolhall::client
