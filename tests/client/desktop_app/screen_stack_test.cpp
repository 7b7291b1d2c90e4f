#include "client/desktop/app/screen_stack.hpp"

#include "client/desktop/app/help_screen.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace poolhall::client {
namespace {

/// Notes what it is asked, and answers as it is told.
class Scripted : public Screen {
  public:
    Scripted(int name, std::vector<int>& heard, Answer answer)
        : name_(name), heard_(heard), answer_(answer) {}

    Answer handle(const ScreenEvent& /*event*/) override {
        heard_.push_back(name_);
        ++revision_;
        return answer_;
    }

    void update(double /*dt*/, double /*now*/) override { heard_.push_back(name_); }

    void draw(const Frame& /*frame*/) override { heard_.push_back(name_); }

    [[nodiscard]] std::uint64_t revision() const override { return revision_; }

    [[nodiscard]] double due_in(double /*now*/) const override { return name_; }

    [[nodiscard]] std::string title() const override {
        return name_ == 2 ? "" : std::to_string(name_);
    }

  private:
    int name_;
    std::vector<int>& heard_;
    Answer answer_;
    std::uint64_t revision_ = 0;
};

class ScreenStackTest : public ::testing::Test {
  protected:
    void push(int name, Answer answer) {
        stack_.push(std::make_unique<Scripted>(name, heard_, answer));
    }

    bool handle(Uint32 type, SDL_Keycode key = SDLK_UNKNOWN) {
        SDL_Event event{};
        event.type = type;
        if (type == SDL_MOUSEBUTTONDOWN) event.button.button = SDL_BUTTON_LEFT;
        return stack_.handle({event, key, {0, 0}});
    }

    std::vector<int> heard_;
    ScreenStack stack_;
};

TEST_F(ScreenStackTest, EventsComeToTheUppermostFirstUntilOneTakesThem) {
    push(1, Answer::kTaken);
    push(2, Answer::kTaken);
    push(3, Answer::kPassed);
    EXPECT_TRUE(handle(SDL_KEYDOWN));
    EXPECT_EQ(heard_, (std::vector{3, 2}));
}

TEST_F(ScreenStackTest, WhatNoneTakesIsTheProgramsOwn) {
    EXPECT_FALSE(handle(SDL_KEYDOWN));
    push(1, Answer::kPassed);
    push(2, Answer::kPassed);
    EXPECT_FALSE(handle(SDL_KEYDOWN));
    EXPECT_EQ(heard_, (std::vector{2, 1}));
}

TEST_F(ScreenStackTest, TimePassesForAllOfThem) {
    push(1, Answer::kPassed);
    push(2, Answer::kPassed);
    stack_.update(0.1, 5);
    EXPECT_EQ(heard_, (std::vector{1, 2}));
    EXPECT_EQ(stack_.due_in(5), 1);
}

TEST_F(ScreenStackTest, ScreenThatClosesIsGoneAndThePictureIsNotTheSame) {
    push(1, Answer::kTaken);
    push(2, Answer::kClose);
    std::uint64_t before = stack_.revision();
    EXPECT_TRUE(handle(SDL_KEYDOWN));
    EXPECT_GT(stack_.revision(), before);
    before = stack_.revision();
    EXPECT_TRUE(handle(SDL_KEYDOWN));
    EXPECT_EQ(heard_, (std::vector{2, 1}));
    EXPECT_GT(stack_.revision(), before);
}

TEST_F(ScreenStackTest, TitleIsThatOfTheUppermostThatHasOne) {
    EXPECT_EQ(stack_.title(), "");
    push(1, Answer::kPassed);
    push(2, Answer::kPassed);
    EXPECT_EQ(stack_.title(), "1");
    push(3, Answer::kPassed);
    EXPECT_EQ(stack_.title(), "3");
}

TEST_F(ScreenStackTest, HelpTakesTheMouseAndLeavesOtherKeysToTheTable) {
    push(1, Answer::kTaken);
    stack_.push(std::make_unique<HelpScreen>());
    EXPECT_TRUE(handle(SDL_MOUSEMOTION));
    EXPECT_EQ(heard_, std::vector<int>{});
    EXPECT_TRUE(handle(SDL_KEYDOWN, SDLK_F3));
    EXPECT_EQ(heard_, std::vector{1});
}

TEST_F(ScreenStackTest, SpaceAClickAndF1CloseTheHelpAndDoNoMore) {
    push(1, Answer::kTaken);
    const std::pair<Uint32, SDL_Keycode> ways[] = {
        {SDL_KEYDOWN, SDLK_SPACE}, {SDL_KEYDOWN, SDLK_F1}, {SDL_MOUSEBUTTONDOWN, SDLK_UNKNOWN}};
    for (const auto& [type, key] : ways) {
        heard_.clear();
        stack_.push(std::make_unique<HelpScreen>());
        EXPECT_TRUE(handle(type, key));
        EXPECT_EQ(heard_, std::vector<int>{}) << "the help took it";
        EXPECT_TRUE(handle(type, key));
        EXPECT_EQ(heard_, std::vector{1}) << "the help is gone";
    }
}

}  // namespace
}  // namespace poolhall::client
