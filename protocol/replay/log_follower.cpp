#include "protocol/replay/log_follower.hpp"

#include "protocol/wire/tagged.hpp"
#include "shared/physics/scene/trace.hpp"

#include <algorithm>
#include <utility>

namespace poolhall::protocol {

namespace {

std::string subject_of(std::uint64_t n, const ReplayRecord& record) {
    if (const auto* shot = std::get_if<ShotRecord>(&record))
        return "shot " + std::to_string(shot->shot);
    std::string_view kind = kind_of(record);
    if (const auto* move = std::get_if<MoveRecord>(&record)) {
        if (move->shot) return "shot " + std::to_string(move->shot->shot);
        kind = wire::type_of(move->move);
    }
    return "record " + std::to_string(n) + " (" + std::string(kind) + ")";
}

std::string reason_of(const MoveRefusal& refusal) {
    switch (refusal.fault) {
        case MoveFault::kNotYourTurn:
            return "it was not that seat's turn";
        case MoveFault::kGameOver:
            return "the game was over before it";
        case MoveFault::kNotOver:
            return "the game was not over before it";
        case MoveFault::kClockStillRuns:
            return "the match has no shot clock";
        case MoveFault::kIllegal:
            break;
    }
    return "the rules do not allow it (" + std::string(name(refusal.illegal.code)) +
           (refusal.illegal.field.empty() ? "" : " at " + std::string(refusal.illegal.field)) + ")";
}

/// All of a scene that no shot changes.
Scene without_balls(Scene scene) {
    scene.balls.clear();
    return scene;
}

/// What can be said of a shot that another edition played otherwise.
void compare_across_editions(const MatchStep& step, const MoveRecord& record,
                             const ShotComparison& shot, Followed& followed) {
    const GameState& here = step.after.game;
    const Scene frame = without_balls(here.scene);
    const Scene recorded = without_balls(record.state.scene);
    if (frame != recorded)
        followed.found.deviations.push_back("state " + first_difference(frame, recorded));
    std::string remark = "played by edition " + std::to_string(record.shot->edition) +
                         " of the physics: " + distance_in_words(here, record.state) + ", " +
                         shot.parting;
    if (step.ruling() != record.ruling)
        remark += ", ruling " + in_words(step.ruling()) + " expected " + in_words(record.ruling);
    followed.found.remarks.push_back(std::move(remark));
}

}  // namespace

Followed LogFollower::follow(const ReplayRecord& record) {
    Followed followed;
    followed.subject = subject_of(++records_, record);
    std::visit([&](const auto& alternative) { take(alternative, followed); }, record);
    return followed;
}

void LogFollower::take(const MatchRecord& record, Followed& followed) {
    rules_ = find_ruleset(record.game);
    settings_ = record.settings.value_or(MatchSettings{});
    if (rules_ == nullptr) return;
    if (const auto fault = check(*rules_, settings_)) {
        followed.found.deviations.push_back("the settings cannot be played: " + fault->pointer +
                                            " " + fault->reason);
        settings_.game = {};
    }
    if (record.first) begin_match(*record.first);
}

void LogFollower::begin_match(Seat first) {
    match_.emplace(MatchSpec{rules_, first, settings_});
}

void LogFollower::take(const SeatRecord& record, Followed& /*followed*/) {
    names_[record.seat.value] = record.name;
    if (match_) match_->reset_seat(record.seat);
}

void LogFollower::take(const EndRecord& /*record*/, Followed& /*followed*/) {
    ended_ = true;
}

void LogFollower::check_number(std::uint32_t shot, Findings& found) {
    const std::uint32_t expected = shots_ + 1;
    if (shot != expected)
        found.deviations.push_back(
            differs("number", std::to_string(shot), std::to_string(expected)));
    shots_ = shot;
}

// ---- version 2

void LogFollower::take(const MoveRecord& record, Followed& followed) {
    auto& deviations = followed.found.deviations;
    if (record.shot) {
        edition_of_log_ = record.shot->edition;
        check_number(record.shot->shot, followed.found);
    }
    at_ms_ = record.at_ms;
    // How states are hashed is a matter of the edition, too.
    const std::uint64_t hash = hash_of(record.state);
    if (edition_of_log_ == edition_ && hash != record.state_hash)
        deviations.push_back(differs("state hash", to_hex(hash), to_hex(record.state_hash)));
    if (!match_) {
        if (knows_rules()) deviations.emplace_back("no game was begun before it");
        return;
    }
    const std::int64_t at_ms = time_of(record);
    if (const auto refusal = match_->find_fault(record.seat, record.move, at_ms)) {
        deviations.push_back(reason_of(*refusal));
        go_on_from(record, nullptr);
        return;
    }
    MatchStep step = match_->play(record.seat, record.move, at_ms);
    step.made.at_ms = record.at_ms;
    if (gives(step, record, followed)) {
        match_->commit(std::move(step), record.at_ms);
    } else {
        go_on_from(record, &step);
    }
}

/// When the move was made. That a clock had run down is for whoever kept it to say: how long a
/// match stood still, and from when its clock ran, is not in its log.
std::int64_t LogFollower::time_of(const MoveRecord& record) {
    if (!std::holds_alternative<TimeOut>(record.move)) return record.at_ms;
    match_->start_clock(record.at_ms);
    return match_->clock_ends_ms().value_or(record.at_ms);
}

/// Whether the move led to the recorded state; says what deviates.
bool LogFollower::gives(const MatchStep& step, const MoveRecord& record, Followed& followed) const {
    auto& deviations = followed.found.deviations;
    if (step.made.move != record.move)
        deviations.push_back("move " + first_difference(step.made.move, record.move));
    const bool agrees = step.ruling() == record.ruling && step.after.game == record.state;
    if (record.shot && step.shot() != nullptr) {
        const auto shot = compare(step.shot()->simulated, *record.shot, edition_, followed.found);
        followed.shot = {shot.hash, shot.as_recorded && (agrees || shot.same_edition)};
        if (!shot.same_edition && !followed.shot->as_recorded) {
            compare_across_editions(step, record, shot, followed);
            return false;
        }
    }
    if (step.ruling() != record.ruling)
        deviations.push_back(differs("ruling", in_words(step.ruling()), in_words(record.ruling)));
    if (step.after.game != record.state)
        deviations.push_back("state " + first_difference(step.after.game, record.state));
    return agrees;
}

/// The recorded state counts. `played`: what the move came to here, if it might be made at all.
void LogFollower::go_on_from(const MoveRecord& record, const MatchStep* played) {
    const MadeMove made{record.seat, record.move, record.at_ms, record.state_hash};
    if (played != nullptr && std::holds_alternative<Agree>(record.move)) {
        MatchStep step = *played;
        step.made = made;
        step.recorded = true;
        step.after.game = record.state;
        step.after.legal = rules_->legal(record.state);
        match_->commit(std::move(step), record.at_ms);
        return;
    }
    Turn turn{record.state, record.ruling, std::nullopt};
    const ShotTaken* shot = played != nullptr ? played->shot() : nullptr;
    if (record.shot) turn.shot = shot != nullptr ? shot->simulated : SimulatedShot{};
    match_->commit(match_->recorded(made, turn), record.at_ms);
}

}  // namespace poolhall::protocol
