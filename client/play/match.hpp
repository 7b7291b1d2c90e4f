#pragma once

#include "client/play/view_state.hpp"
#include "protocol/messages.hpp"
#include "shared/game/ruleset.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace poolhall::client {

/// A match as this client knows it now. What is shown may lag behind: the shots on their way are in
/// the Playback.
struct MatchInfo {
    /// None before the first word from the server.
    std::optional<protocol::TableState> table;
    std::array<bool, kSeatCount> mine{};  ///< seats played from here
    Link link = Link::kOffline;
    std::optional<double> round_trip_ms;
    std::string kernel;  ///< that simulated the last shot; empty before one
    /// Why there is no table, or that the connection is lost; one sentence, empty when all is well.
    std::string trouble;
    std::uint64_t revision = 0;  ///< rises with every change

    /// The seat that may shoot from here, if it is its turn.
    [[nodiscard]] std::optional<Seat> acting_seat() const;

    [[nodiscard]] bool seated() const { return mine[0] || mine[1]; }

    [[nodiscard]] bool hot_seat() const { return mine[0] && mine[1]; }
};

/// The one source of truth of a match, played here or over the network. It feeds the Playback that
/// it was made with.
class Match {
  public:
    Match() = default;
    Match(const Match&) = delete;
    Match& operator=(const Match&) = delete;
    virtual ~Match() = default;

    [[nodiscard]] virtual const MatchInfo& info() const = 0;

    /// Takes in what has happened; `now` in s, never falling.
    virtual void poll(double now) = 0;
    /// How long poll may wait before something of its own is due, s.
    [[nodiscard]] virtual double due_in(double now) const = 0;
    /// A line for the player that came up since the last call: what was refused, who came.
    [[nodiscard]] virtual std::string take_notice() = 0;

    // Commands of the acting seat; without one they do nothing. Directions of any length but zero.
    virtual void aim(Vec2 direction) = 0;
    virtual void place_cue_ball(Vec2 position) = 0;
    virtual void shoot(Vec2 direction) = 0;

    /// Another game, when one is over: at once, or a vote for it.
    virtual void ask_new_game() = 0;
    /// Takes the open seat too, or gives it back.
    virtual void toggle_hot_seat() = 0;
    /// A lost connection is tried again at once rather than at the end of its pause.
    virtual void retry_now() = 0;
};

/// What the rules need to know to judge placement and aim in the game that the table shows.
[[nodiscard]] GameState game_state_of(const protocol::TableState& table);

}  // namespace poolhall::client
