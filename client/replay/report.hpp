#pragma once

#include "protocol/archive/archive.hpp"
#include "protocol/replay/log_follower.hpp"
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

/// Prints a match record by record, of either version.
class ReplayPrinter {
  public:
    explicit ReplayPrinter(std::ostream& out) : out_(out) {}

    void print(const protocol::ReplayRecord& record);

  private:
    void print_record(const protocol::MatchRecord& match);
    void print_record(const protocol::SeatRecord& seat);
    void print_record(const protocol::MoveRecord& move);
    void print_record(const protocol::GameRecord& game);
    void print_record(const protocol::ShotRecord& shot);
    void print_record(const protocol::EndRecord& end);

    void print_game(std::uint32_t number, Seat first);
    void print_move(const protocol::MoveRecord& move, const std::string& words);
    void print_winner(const std::optional<Ruling>& ruling);
    [[nodiscard]] std::string name_of(Seat seat) const;

    std::ostream& out_;
    PerSeat<std::string> names_;
    std::uint32_t games_ = 0;  ///< begun so far
};

/// "shot 3: ok 0123456789abcdef", or a line for each divergence; of other records only what is
/// worth saying.
void print_followed(std::ostream& out, const protocol::Followed& followed);

}  // namespace poolhall::client
