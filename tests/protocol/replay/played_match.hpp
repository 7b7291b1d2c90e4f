#pragma once

#include "protocol/replay/record.hpp"

#include <cstdint>
#include <string>
#include <vector>

// Matches of the Pool End Game, really played, for the tests of whatever keeps or reads them.
namespace poolhall::test {

/// A closed match between Ann and Bob of at least `shots` shots, with games won, lost and begun
/// again.
[[nodiscard]] std::vector<protocol::ReplayRecord> played_match(const std::string& id,
                                                               std::uint32_t shots,
                                                               const GameSettings& settings = {});

/// The records as a replay file.
[[nodiscard]] std::string replay_file(const std::vector<protocol::ReplayRecord>& records);

/// One line of a replay file, with a good checksum.
[[nodiscard]] std::string replay_line(std::uint64_t n, const protocol::ReplayRecord& record);

}  // namespace poolhall::test
