#pragma once

#include "client/play/link.hpp"
#include "protocol/messages.hpp"
#include "shared/analysis/effect_use.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace poolhall::client {

/// A match as this client knows it now. What is shown may lag behind: the shots on their way are in
/// the Playback.
struct MatchInfo {
    /// None before the first word from the server.
    std::optional<protocol::TableState> table;
    PerSeat<bool> mine{};  ///< seats played from here
    Link link = Link::kOffline;
    std::optional<double> round_trip_ms;
    /// When the shot clock of the turn runs down, s on the clock of poll(); none while none runs.
    std::optional<double> clock_ends;
    std::string kernel;                        ///< that simulated the last shot; empty before one
    std::vector<analysis::EffectUse> effects;  ///< of the last shot
    /// Why there is no table, or that the connection is lost; one sentence, empty when all is well.
    std::string trouble;
    std::uint64_t revision = 0;  ///< rises with every change

    /// The seat that may place and shoot from here, if it is its turn.
    [[nodiscard]] std::optional<Seat> acting_seat() const;

    [[nodiscard]] bool seated() const { return mine[0] || mine[1]; }

    [[nodiscard]] bool hot_seat() const { return mine[0] && mine[1]; }
};

/// The seats here that would make the move now: the one whose turn it is, every one that has not
/// agreed yet, the one that gives up. None if it is nobody's here.
[[nodiscard]] std::vector<Seat> movers(const MatchInfo& info, const Move& move);

/// The one source of truth of a match, played here or over the network. It feeds the Playback that
/// it was made with.
class ClientMatch {
  public:
    ClientMatch() = default;
    ClientMatch(const ClientMatch&) = delete;
    ClientMatch& operator=(const ClientMatch&) = delete;
    virtual ~ClientMatch() = default;

    [[nodiscard]] virtual const MatchInfo& info() const = 0;

    /// Takes in what has happened; `now` in s, never falling.
    virtual void poll(double now) = 0;
    /// How long poll may wait before something of its own is due, s.
    [[nodiscard]] virtual double due_in(double now) const = 0;
    /// A line for the player that came up since the last call: what was refused, who came.
    [[nodiscard]] virtual std::string take_notice() = 0;

    // What the acting seat is about to do; without one they do nothing.
    /// Direction of any length but zero.
    virtual void aim(Vec2 direction) = 0;
    /// Holds the cue ball in hand at the legal place nearest to `position`, m; the aim turns anew.
    virtual void hold_cue_ball(Vec2 position) = 0;

    /// Makes the move for the seats here that it is for, if any; see movers(). Right before a shot
    /// the cue ball is placed where it is held.
    virtual void make(const Move& move) = 0;

    /// Takes the open seat too, or gives it back.
    virtual void toggle_hot_seat() = 0;
    /// A lost connection is tried again at once rather than at the end of its pause.
    virtual void retry_now() = 0;
};

}  // namespace poolhall::client
