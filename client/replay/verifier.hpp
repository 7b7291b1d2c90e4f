#pragma once

#include "protocol/replay/record.hpp"
#include "shared/game/ruleset.hpp"
#include "shared/game/settings.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace poolhall::client {

/// What came of verifying one shot.
struct ShotReport {
    std::uint32_t shot = 0;
    std::uint64_t hash = 0;  ///< as simulated here
    /// One clause each: "hash 0123456789abcdef expected fedcba9876543210". None: the shot is as
    /// recorded.
    std::vector<std::string> divergences;
};

/// Plays a match again, record by record. Of each shot it checks that the scene follows from the
/// rules and the shot before it as that was recorded, that simulating it gives the recorded result,
/// and that the rules say what was recorded. After a divergence it goes on from the record, so that
/// a changed shot shows in itself and at most in the next one.
class Verifier {
  public:
    /// Takes the next record of the match; the answer to a shot.
    std::optional<ShotReport> follow(const protocol::ReplayRecord& record);

    /// False if the match is of a game that this program does not know: then only the shots' own
    /// results are checked.
    [[nodiscard]] bool knows_rules() const { return rules_ != nullptr; }

  private:
    using Divergences = std::vector<std::string>;

    void begin_match(const protocol::MatchRecord& match);
    void begin_game(const protocol::GameRecord& game);
    ShotReport check(const protocol::ShotRecord& shot);
    void check_rules(const protocol::ShotRecord& shot, Divergences& found);
    void check_chain(const protocol::ShotRecord& shot, Divergences& found);
    [[nodiscard]] GameState state_before(const protocol::ShotRecord& shot) const;

    const Ruleset* rules_ = nullptr;
    GameSettings settings_;                     ///< of the match
    std::optional<SceneError> settings_fault_;  ///< why no server can have taken them
    std::uint32_t shots_ = 0;                   ///< so far in the match
    std::uint32_t game_number_ = 0;             ///< of the game that is played
    std::uint32_t game_shots_ = 0;              ///< so far in this game
    std::optional<GameState> state_;            ///< what the records so far lead to
};

}  // namespace poolhall::client
