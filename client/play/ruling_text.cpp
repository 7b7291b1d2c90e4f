#include "client/play/ruling_text.hpp"

#include <algorithm>
#include <array>

namespace poolhall::client {
namespace {

/// How each game is won.
struct WonText {
    std::string_view game;
    std::string_view text;
};

constexpr std::array kWonTexts{WonText{EndGamePart::kType, "The 8-ball is down"}};

std::string_view won_text(std::string_view game) {
    const auto* found = std::find_if(kWonTexts.begin(), kWonTexts.end(),
                                     [game](const WonText& won) { return won.game == game; });
    return found == kWonTexts.end() ? "The game is won" : found->text;
}

}  // namespace

std::string ruling_text(std::string_view game, const Ruling& ruling, const std::string& shooter) {
    const bool you = shooter == "You";
    switch (ruling.verdict) {
        case Verdict::kTurnPasses:
            return "The turn passes";
        case Verdict::kWon:
            return std::string(won_text(game));
        case Verdict::kScratch:
            return "Scratch: " + (you ? "you" : shooter) + " sank the cue ball";
        case Verdict::kConceded:
            return shooter + " gave the game up";
        case Verdict::kTimedOut:
            return (you ? "Your" : shooter + "'s") + " time is up: the turn passes";
    }
    return "";
}

}  // namespace poolhall::client
