#pragma once

#include "protocol/replay/record.hpp"

#include <cstdint>
#include <string>
#include <vector>

// Matches of the Pool End Game, really played, for the tests of whatever keeps or reads them.
namespace poolhall::test {

/// A closed match between Ann and Bob of that many shots, with games won, lost and begun again.
[[nodiscard]] std::vector<protocol::ReplayRecord> played_match(const std::string& id,
                                                               std::uint32_t shots,
                                                               const MatchSettings& settings = {});

/// The same as version 1 of the format has it.
[[nodiscard]] std::vector<protocol::ReplayRecord> played_match_v1(
    const std::string& id, std::uint32_t shots, const GameSettings& settings = {});

/// The first record of a version-2 match that seat 0 begins.
[[nodiscard]] protocol::MatchRecord match_record(const std::string& id);

/// Some move that is no shot.
[[nodiscard]] protocol::MoveRecord some_move(std::int64_t at_ms);

/// The records as a replay file.
[[nodiscard]] std::string replay_file(const std::vector<protocol::ReplayRecord>& records);

/// One line of a replay file, with a good checksum.
[[nodiscard]] std::string replay_line(std::uint64_t n, const protocol::ReplayRecord& record);

}  // namespace poolhall::test
