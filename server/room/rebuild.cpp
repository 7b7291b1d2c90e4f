#include "server/room/rebuild.hpp"

#include "shared/physics/scene/trace.hpp"

#include <optional>
#include <utility>
#include <variant>

namespace poolhall::server {
namespace {

using protocol::EndRecord;
using protocol::GameRecord;
using protocol::MatchRecord;
using protocol::SeatRecord;
using protocol::ShotRecord;

using Fault = std::optional<std::string>;

/// Applies records in their order; each answers what is wrong with it, or nothing.
class Rebuilder {
  public:
    explicit Rebuilder(const StoredMatch& stored) : stored_(stored) {}

    Fault operator()(const MatchRecord& record) {
        if (rules_) return "a second match record";
        rules_ = find_ruleset(record.game);
        if (!rules_) return "the game '" + record.game + "' is unknown";
        settings_ = record.settings.value_or(GameSettings{});
        if (const auto fault = check(*rules_, settings_))
            return "its settings' " + fault->pointer + " " + fault->reason;
        return {};
    }

    Fault operator()(const GameRecord& record) {
        if (!rules_) return "a game before the match record";
        if (!match_) {
            match_.emplace(MatchSpec{stored_.id, stored_.code, rules_, record.first, settings_});
            return {};
        }
        if (match_->phase() != protocol::Phase::kOver || record.first != match_->next_first())
            return "game " + std::to_string(record.game_number) +
                   " does not follow from the one before";
        match_->start_next_game();
        return {};
    }

    Fault operator()(const SeatRecord& record) {
        if (!match_) return "a seat before the first game";
        if (match_->holder(record.seat)) match_->leave_seat(record.seat);
        // The token of the last holder; those before have left and need none.
        if (!record.name.empty())
            match_->take_seat(record.seat,
                              {record.name, stored_.seats[record.seat.value].token_hash, {}});
        return {};
    }

    Fault operator()(const ShotRecord& record) {
        const std::string shot = "shot " + std::to_string(record.shot);
        if (!match_ || record.shot != match_->shots() + 1) return shot + " is out of order";
        if (Fault fault = place_as_in(record.scene)) return shot + fault.value();
        const ShotCommand command{record.scene.strike ? record.scene.strike->direction : Vec2{}};
        if (match_->rules().check_shot(match_->game(), command)) return shot + " is not legal";
        ShotOutcome outcome = match_->rules().play(match_->game(), command);
        if (hash_of(outcome.scene) != record.scene_hash) return shot + " starts from another scene";
        if (outcome.trace.hash != record.final_hash)
            return shot + " DIVERGED: logged " + to_hex(record.final_hash) + ", simulated " +
                   to_hex(outcome.trace.hash);
        if (outcome.ruling != record.ruling) return shot + " was ruled otherwise";
        match_->start_shot(std::move(outcome), {});
        match_->finish_shot();
        return {};
    }

    Fault operator()(const EndRecord&) { return "it has ended"; }

    [[nodiscard]] std::optional<Match>& match() { return match_; }

  private:
    /// Where the cue ball was put is not logged by itself: the shot's scene has it.
    Fault place_as_in(const Scene& scene) {
        const std::size_t cue = match_->game().cue_ball.value;
        if (cue >= scene.balls.size()) return " has no cue ball";
        const Vec2 placed = xy(scene.balls[cue].state.r);
        if (placed == match_->cue_ball()) return {};
        GameState trial = match_->game();
        if (match_->rules().place_cue_ball(trial, placed))
            return " has the cue ball where it may not be";
        match_->place_cue_ball(placed);
        return {};
    }

    const StoredMatch& stored_;
    const Ruleset* rules_ = nullptr;
    GameSettings settings_;
    std::optional<Match> match_;
};

}  // namespace

Result<Match, std::string> rebuild(const StoredMatch& stored) {
    Rebuilder rebuilder(stored);
    for (const auto& record : stored.records)
        if (Fault fault = std::visit(rebuilder, record)) return *fault + ".";
    if (!rebuilder.match()) return std::string("It has no game.");
    return *std::move(rebuilder.match());
}

}  // namespace poolhall::server
