#pragma once

#include "client/replay/verifier.hpp"
#include "protocol/archive/archive.hpp"
#include "protocol/replay/record.hpp"

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

// What the commands print. Nothing of a replay reaches the terminal with its control characters.
namespace poolhall::client {

/// "2026-11-23 01:24:43", UTC.
[[nodiscard]] std::string time_text(std::int64_t unix_ms);

void print_list(std::ostream& out, const std::vector<protocol::ReplaySummary>& replays);

/// Prints a match record by record.
class ReplayPrinter {
  public:
    explicit ReplayPrinter(std::ostream& out) : out_(out) {}

    void print(const protocol::ReplayRecord& record);

  private:
    void print_record(const protocol::MatchRecord& match);
    void print_record(const protocol::SeatRecord& seat);
    void print_record(const protocol::GameRecord& game);
    void print_record(const protocol::ShotRecord& shot);
    void print_record(const protocol::EndRecord& end);
    [[nodiscard]] std::string name_of(Seat seat) const;

    std::ostream& out_;
    std::array<std::string, kSeatCount> names_;
};

/// "shot 3: ok 0123456789abcdef", or a line for each divergence.
void print_report(std::ostream& out, const ShotReport& report);

}  // namespace poolhall::client
