#pragma once

#include "protocol/replay/record.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Comparing what a record says with what this program finds.
namespace poolhall::protocol {

/// What following a record has found: clauses, to be put behind the record's name.
struct Findings {
    /// What cannot be, unless the record or the program is wrong: "hash 01.. expected 23..".
    std::vector<std::string> deviations;
    /// What is worth saying, and nobody's fault: another edition of the physics made it.
    std::vector<std::string> remarks;
};

/// "WHAT FOUND expected EXPECTED".
[[nodiscard]] std::string differs(std::string_view what, std::string_view found,
                                  std::string_view expected);

/// Where two scenes, states or moves first differ in their JSON form, with both values:
/// "/balls/0/r/0 0.1 expected 0.2". They must differ.
[[nodiscard]] std::string first_difference(const Scene& found, const Scene& expected);
[[nodiscard]] std::string first_difference(const GameState& found, const GameState& expected);
[[nodiscard]] std::string first_difference(const Move& found, const Move& expected);

/// "won by seat 0, next 1, won by 0, decided at 1.5 s"; "none".
[[nodiscard]] std::string in_words(const std::optional<Ruling>& ruling);

/// How far apart the balls of two states lie: "same final states", "final states up to 3.2 mm apart
/// (ball 8)", "ball 8 is on the table only in the record".
[[nodiscard]] std::string distance_in_words(const GameState& here, const GameState& recorded);

/// The evidence of a version-1 record.
[[nodiscard]] ShotEvidence evidence_of(const ShotRecord& shot);

/// A recorded shot and what simulating it gave.
struct ShotComparison {
    std::uint64_t hash = 0;     ///< as simulated here
    bool as_recorded = false;   ///< the hashes agree
    bool same_edition = false;  ///< as this program's
    /// Where the two part, as far as the record tells: "first at event 3 (ball_ball) at ..".
    std::string parting;
};

/// Compares a simulated shot with its evidence. `edition` is this program's: of a shot that another
/// one made, what differs is no deviation, and is left to the caller to remark on. A recorded
/// kernel other than the simulated one has to give the same.
[[nodiscard]] ShotComparison compare(const SimulatedShot& simulated, const ShotEvidence& evidence,
                                     std::uint32_t edition, Findings& found);

}  // namespace poolhall::protocol
