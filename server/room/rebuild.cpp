#include "server/room/rebuild.hpp"

#include "shared/math/state_hash.hpp"
#include "shared/physics/edition.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace poolhall::server {
namespace {

using protocol::EndRecord;
using protocol::GameRecord;
using protocol::MatchRecord;
using protocol::MoveRecord;
using protocol::SeatRecord;
using protocol::ShotRecord;

using Fault = std::optional<std::string>;

/// Applies records in their order; each answers what is wrong with it, or nothing.
class Rebuilder {
  public:
    explicit Rebuilder(const StoredMatch& stored) : stored_(stored) {}

    Fault operator()(const MatchRecord& record) {
        if (table_) return "a second match record";
        const Ruleset* rules = find_ruleset(record.game);
        if (!rules) return "the game '" + record.game + "' is unknown";
        const MatchSettings settings = record.settings.value_or(MatchSettings{});
        if (const auto fault = check(*rules, settings))
            return "its settings' " + fault->pointer + " " + fault->reason;
        if (!record.first) return "its log is of an older version";
        table_.emplace(stored_.id, stored_.code, MatchSpec{rules, *record.first, settings});
        return {};
    }

    Fault operator()(const SeatRecord& record) {
        if (!table_) return "a seat before the match record";
        if (table_->roster.holder(record.seat)) table_->leave_seat(record.seat);
        // The token of the last holder; those before have left and need none.
        if (!record.name.empty())
            table_->take_seat(record.seat,
                              {record.name, stored_.seats[record.seat.value].token_hash, {}});
        return {};
    }

    Fault operator()(const MoveRecord& record) {
        if (!table_) return "a move before the match record";
        const std::string move = "move " + std::to_string(table_->match.moves().size() + 1);
        if (record.shot && record.shot->shot != table_->match.now().shots + 1)
            return move + " is out of order";
        // From when a clock ran is not logged; that it had run down is.
        if (std::holds_alternative<TimeOut>(record.move)) table_->match.start_clock(0);
        const std::int64_t at =
            std::max(record.at_ms, table_->match.clock_ends_ms().value_or(record.at_ms));
        if (table_->match.find_fault(record.seat, record.move, at)) return move + " is not legal";
        MatchStep step = play(record, at);
        step.made.at_ms = record.at_ms;
        if (hash_of(step.after.game) != record.state_hash)
            return move + " DIVERGED: logged " + to_hex(record.state_hash) + ", played " +
                   to_hex(hash_of(step.after.game));
        table_->commit(std::move(step), record.at_ms);
        return {};
    }

    Fault operator()(const EndRecord&) { return "it has ended"; }

    Fault operator()(const GameRecord&) { return "its log is of an older version"; }

    Fault operator()(const ShotRecord&) { return "its log is of an older version"; }

    [[nodiscard]] std::optional<Table>& table() { return table_; }

  private:
    /// A shot of another physics is taken as it was recorded.
    [[nodiscard]] MatchStep play(const MoveRecord& record, std::int64_t at_ms) const {
        if (!record.shot || record.shot->edition == kPhysicsEdition)
            return table_->match.play(record.seat, record.move, at_ms);
        Turn turn{record.state, record.ruling, SimulatedShot{table_->match.now().game.scene, {}}};
        return table_->match.recorded({record.seat, record.move, at_ms, record.state_hash}, turn);
    }

    const StoredMatch& stored_;
    std::optional<Table> table_;
};

}  // namespace

Result<Table, std::string> rebuild(const StoredMatch& stored) {
    Rebuilder rebuilder(stored);
    for (const auto& record : stored.records)
        if (Fault fault = std::visit(rebuilder, record)) return *fault + ".";
    if (!rebuilder.table()) return std::string("It has no game.");
    return *std::move(rebuilder.table());
}

}  // namespace poolhall::server
