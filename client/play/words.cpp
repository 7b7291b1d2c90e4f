#include "client/play/words.hpp"

#include "client/play/isolated.hpp"
#include "client/play/ruling_text.hpp"
#include "protocol/text.hpp"
#include "shared/analysis/effect_use.hpp"
#include "shared/physics/simulate.hpp"

#include <array>
#include <cstdio>

namespace poolhall::client {
namespace {

using protocol::Phase;
using protocol::TableState;

bool practice(const MatchInfo& info) {
    return info.link == Link::kOffline;
}

std::string waiting_hint(const MatchInfo& info, const TableState& table) {
    const std::string waiting =
        "Waiting for a second player: code " + protocol::spoken_code(table.code);
    return info.seated() ? waiting + ", or press H to play both seats" : waiting;
}

std::string aiming_hint(const MatchInfo& info, const TableState& table) {
    const auto& seat = table.seats[table.legal.seat.value];
    if (!info.mine[table.legal.seat.value]) {
        return seat.connected ? isolated(seat.name) + " is aiming"
                              : isolated(seat.name) + " has lost the connection; the seat is kept";
    }
    const std::string whose = info.hot_seat() ? isolated(seat.name) + "'s turn: " : "Your turn: ";
    const std::string place = table.legal.place ? "Up and Down place the cue ball, " : "";
    return whose + place + "Left and Right aim, Space shoots";
}

std::string rematch_hint(const MatchInfo& info, const TableState& table) {
    if (!info.seated()) return "The players may play again";
    if (practice(info)) return "Space starts a new game";
    for (std::size_t i = 0; i < kSeatCount; ++i) {
        if (info.mine[i] && !table.seats[i].wants_rematch) return "Space asks for a rematch";
    }
    for (std::size_t i = 0; i < kSeatCount; ++i) {
        if (!info.mine[i])
            return "Waiting for " + isolated(table.seats[i].name) + " to agree to a rematch";
    }
    return "";
}

/// "You", or the name of who sits there; with the seat where both have one name.
std::string who(Seat seat, const MatchInfo& info, const TableState& table) {
    if (info.mine[seat.value] && !info.hot_seat()) return "You";
    const std::string name = isolated(table.seats[seat.value].name);
    const bool same = table.seats[0].name == table.seats[1].name;
    return same ? name + (seat.value == 0 ? " (left seat)" : " (right seat)") : name;
}

std::string title_of(const Ruling& result, const MatchInfo& info, const TableState& table) {
    const Seat loser = opponent(*result.winner);
    const bool i_lose = info.mine[loser.value] && !info.hot_seat();
    if (i_lose) return table.winner ? "You lose the match" : "You lose";
    const std::string winner = who(*result.winner, info, table);
    const std::string what = table.winner ? " the match" : "";
    return winner + (winner == "You" ? " win" : " wins") + what;
}

}  // namespace

std::string hint(const MatchInfo& info, const ShownTable& shown, bool step_mode) {
    if (info.link == Link::kLost) return "Space tries again at once";
    const auto& table = shown.table();
    if (!table) return info.trouble.empty() ? "" : "Esc leaves";
    if (!shown.at_rest()) {
        if (step_mode)
            return "Step mode: Space advances 1/30 s, F5 adds other solvers, F3 leaves it";
        if (shown.result() && practice(info)) return "Space starts a new game";
        return shown.cue_ball_is_down() ? "Scratch: the cue ball is down" : "";
    }
    switch (table->phase) {
        case Phase::kWaiting:
            return waiting_hint(info, *table);
        case Phase::kAiming:
            return aiming_hint(info, *table);
        case Phase::kPlaying:
            return "";
        case Phase::kOver:
            return rematch_hint(info, *table);
    }
    return "";
}

std::optional<Banner> banner(const MatchInfo& info, const ShownTable& shown) {
    const auto& table = shown.table();
    if (info.link == Link::kLost) {
        return Banner{"Connection lost", info.trouble + "; trying again", Tone::kNeutral};
    }
    if (!table) {
        if (info.trouble.empty()) return Banner{"Connecting", "", Tone::kNeutral};
        return Banner{"No table", info.trouble, Tone::kNeutral};
    }
    const auto result = shown.result();
    if (!result) return std::nullopt;
    return Banner{title_of(*result, info, *table), ruling_sentence(*result, info),
                  tone_of(*result, info)};
}

Tone tone_of(const Ruling& result, const MatchInfo& info) {
    const Seat loser = opponent(*result.winner);
    return info.mine[loser.value] && !info.hot_seat() ? Tone::kLost : Tone::kWon;
}

std::string physics_of(const MatchInfo& info) {
    if (!info.table) return "";
    const auto [kind, hz] = info.table->state.scene.solver;
    std::string words(name(kind));
    std::array<char, 32> rate{};
    std::snprintf(rate.data(), rate.size(), " %g Hz", hz);
    if (has_ticks(kind)) words += rate.data();
    if (info.kernel.empty()) return words;
    words += ", " + info.kernel;
    const std::string effects = analysis::in_words(info.effects);
    return effects.empty() ? words : words + "; " + effects;
}

std::string clock_text(std::uint32_t seconds) {
    constexpr std::uint32_t kMinute = 60;
    std::array<char, 32> text{};
    if (seconds < kMinute) {
        std::snprintf(text.data(), text.size(), "%u s", seconds);
    } else {
        std::snprintf(text.data(), text.size(), "%u:%02u min", seconds / kMinute,
                      seconds % kMinute);
    }
    return text.data();
}

bool has_own_physics(const MatchInfo& info) {
    return info.table && info.table->settings && info.table->settings->game != GameSettings{};
}

std::string ruling_sentence(const Ruling& ruling, const MatchInfo& info) {
    return ruling_text(info.table->game, ruling, who(ruling.shooter, info, *info.table));
}

}  // namespace poolhall::client
