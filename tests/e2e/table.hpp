#pragma once

#include "protocol/encoding.hpp"
#include "protocol/messages.hpp"
#include "shared/match/settings.hpp"
#include "tests/e2e/protocol_client.hpp"
#include "tests/shared/game/played_shot.hpp"

namespace poolhall::e2e {

using test::PlayedShot;

/// The seat shoots in this direction, with all else left to the game.
[[nodiscard]] protocol::MakeMove shot_by(Seat seat, Vec2 direction);
/// The seat wants another game.
[[nodiscard]] protocol::MakeMove rematch_by(Seat seat);

/// Of the shots from here that get this verdict, the one that is over first, as the rules play it.
/// Throws std::runtime_error if none of many directions gets it.
[[nodiscard]] PlayedShot find_shot(const GameState& game, Verdict verdict);

/// The command that makes the server play the same shot.
[[nodiscard]] protocol::MakeMove command_of(const PlayedShot& outcome);

/// Two seated players before the first shot, and the game as the rules alone have it.
struct Duel {
    /// Ann creates the match, Bob joins it.
    explicit Duel(std::uint16_t port, protocol::Encoding ann_speaks = protocol::Encoding::kJson,
                  protocol::Encoding bob_speaks = protocol::Encoding::kCbor,
                  const MatchSettings& settings = {});

    /// Who sits there.
    [[nodiscard]] ProtocolClient& player(Seat seat) { return seat.value == 0 ? ann : bob; }

    /// Plays a shot with this verdict from the seat whose turn it is, to its end for both players.
    PlayedShot play(Verdict verdict);

    ProtocolClient ann;  ///< seat 0
    ProtocolClient bob;  ///< seat 1
    protocol::Joined ann_joined;
    protocol::Joined bob_joined;
    GameState game;
};

/// Expects that what a client heard is the shot that the rules play, to the last bit.
void expect_same_shot(const ShotHeard& heard, const PlayedShot& outcome);
/// Expects the table that follows the shot: its state, what is legal in it, and the phase.
void expect_table_after(const protocol::TableState& table, const PlayedShot& outcome);

}  // namespace poolhall::e2e
