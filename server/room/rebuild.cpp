#include "server/room/rebuild.hpp"

#include "protocol/replay/log_follower.hpp"

#include <utility>
#include <variant>

namespace poolhall::server {

namespace {

/// Why no match came of the log.
std::string missing_match(const StoredMatch& stored) {
    using protocol::MatchRecord;
    if (stored.records.empty() || !std::holds_alternative<MatchRecord>(stored.records.front()))
        return "It has no match record.";
    const std::string& game = std::get<MatchRecord>(stored.records.front()).game;
    return find_ruleset(game) == nullptr ? "Its game '" + game + "' is unknown."
                                         : "It has no game.";
}

}  // namespace

Result<Table, std::string> rebuild(const StoredMatch& stored) {
    protocol::LogFollower log;
    for (const auto& record : stored.records) {
        const protocol::Followed followed = log.follow(record);
        const auto& deviations = followed.found.deviations;
        if (!deviations.empty()) return followed.subject + " DIVERGED: " + deviations.front() + ".";
    }
    if (log.ended()) return std::string("It has ended.");
    if (!log.match()) return missing_match(stored);
    const Match& match = *log.match();
    Table table(stored.id, stored.code, {&match.rules(), match.now().first, match.settings()});
    table.match = match;
    table.aim = {match.now().legal.aim, {}};
    for (const Seat seat : kSeats) {
        const std::string& name = log.names()[seat.value];
        if (!name.empty())
            table.roster.take_seat(seat, {name, stored.seats[seat.value].token_hash, {}});
    }
    return table;
}

}  // namespace poolhall::server
