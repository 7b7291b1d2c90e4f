#pragma once

#include "protocol/replay/record.hpp"
#include "protocol/replay/shot_check.hpp"
#include "shared/match/match.hpp"
#include "shared/physics/edition.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace poolhall::protocol {

/// What following one record has shown.
struct Followed {
    /// A shot as it came out here.
    struct Shot {
        std::uint64_t hash = 0;
        bool as_recorded = false;  ///< else it deviates, or another edition's remark says how
    };

    std::string subject;       ///< "shot 3", "record 7 (place)"
    std::optional<Shot> shot;  ///< where the record is of one that could be simulated
    Findings found;
};

/// Plays a match again, record by record, of whatever version, and checks that each record follows
/// from those before it: that the seat might make the move, and that it gives the recorded state,
/// result and ruling. After a deviation it goes on from the record, so that a changed one shows in
/// itself and at most in the next.
///
/// A shot that another edition of the physics made may come out otherwise here. That is a remark,
/// no deviation, and the recorded state counts. Version 1 records no state after a shot: it is the
/// next shot that shows it.
class LogFollower {
  public:
    /// `edition`: whose results count as this program's own.
    explicit LogFollower(std::uint32_t edition = kPhysicsEdition) : edition_(edition) {}

    /// Takes the next record. Records must be what a ReplayReader gives, in its order.
    Followed follow(const ReplayRecord& record);

    /// The match as it stands; none before its first game, or where the game is unknown here.
    [[nodiscard]] const std::optional<Match>& match() const { return match_; }

    /// Who sits there; empty if nobody does.
    [[nodiscard]] const PerSeat<std::string>& names() const { return names_; }

    /// False if the match is of a game that this program does not know: then only shots that say
    /// themselves what scene they begin from can be checked.
    [[nodiscard]] bool knows_rules() const { return rules_ != nullptr; }

    [[nodiscard]] bool ended() const { return ended_; }

  private:
    void take(const MatchRecord& record, Followed& followed);
    void take(const SeatRecord& record, Followed& followed);
    void take(const MoveRecord& record, Followed& followed);
    void take(const GameRecord& record, Followed& followed);
    void take(const ShotRecord& record, Followed& followed);
    void take(const EndRecord& record, Followed& followed);

    void begin_match(Seat first);
    void check_number(std::uint32_t shot, Findings& found);

    // Version 2
    [[nodiscard]] std::int64_t time_of(const MoveRecord& record);
    [[nodiscard]] bool gives(const MatchStep& step, const MoveRecord& record,
                             Followed& followed) const;
    void go_on_from(const MoveRecord& record, const MatchStep* played);

    // Version 1
    void agree_to_rematch();
    void check_alone(const ShotRecord& record, Followed& followed) const;
    void set_table(const ShotRecord& record, Findings& found);
    [[nodiscard]] std::optional<MatchStep> play_strike(const ShotRecord& record, Findings& found);
    void check_step(MatchStep step, const ShotRecord& record, Followed& followed);

    std::uint32_t edition_;
    std::uint32_t edition_of_log_ = edition_;  ///< of the last shot
    const Ruleset* rules_ = nullptr;
    MatchSettings settings_;
    std::optional<Match> match_;
    PerSeat<std::string> names_;
    std::uint64_t records_ = 0;      ///< so far
    std::uint32_t shots_ = 0;        ///< number of the last one
    std::uint32_t game_number_ = 0;  ///< of the last `game` record
    std::int64_t at_ms_ = 0;         ///< of the last record that says when
    bool is_state_known_ = true;     ///< false: after a version-1 shot of another edition
    bool ended_ = false;
};

}  // namespace poolhall::protocol
