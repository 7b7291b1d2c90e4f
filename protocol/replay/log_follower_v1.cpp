#include "protocol/replay/log_follower.hpp"
#include "shared/physics/scene/trace.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <utility>

// Version 1 logs shots with their scenes, and games. Both become moves: a shot is a placement,
// where its scene has the cue ball elsewhere than the shot before left it, and a strike; a game
// after the first is both seats' consent.
namespace poolhall::protocol {

namespace {

bool has_same_balls(const Scene& a, const Scene& b) {
    return std::ranges::equal(a.balls, b.balls, {}, &SceneBall::id, &SceneBall::id);
}

Vec2 place_of(const Scene& scene, BallIndex ball) {
    return xy(scene.balls[ball.value].state.r);
}

/// The game before a shot as the record has it; `now` as the match has it.
GameState state_before(const GameState& now, const ShotRecord& record) {
    GameState state = now;
    state.scene = record.scene;
    state.scene.strike.reset();
    state.scene.id = now.scene.id;  // a label
    state.cue_ball = record.scene.strike->ball;
    state.turn = record.seat;
    state.over = false;
    state.winner.reset();
    return state;
}

/// The game after a shot that came out otherwise here, going on as the record says.
GameState as_ruled(GameState state, const Ruling& ruling) {
    state.over = ruling.winner.has_value();
    state.winner = ruling.winner;
    state.turn = state.over ? ruling.shooter : ruling.next;
    return state;
}

/// Why a shot can have no such scene after what the match has come to; none if it can. `place`: set
/// where the cue ball was put elsewhere before it.
std::vector<std::string> chain_faults(const Position& now, const ShotRecord& record,
                                      std::optional<Place>& place) {
    std::vector<std::string> faults;
    if (now.game.over) faults.emplace_back("the game was over before it");
    if (now.game.turn != record.seat)
        faults.push_back(differs("shot by seat", std::to_string(record.seat.value),
                                 std::to_string(now.game.turn.value)));
    const Scene& scene = record.scene;
    GameState expected = now.game;
    if (!has_same_balls(expected.scene, scene)) {
        faults.emplace_back("the balls on the table are not those that the shots before it left");
        return faults;
    }
    if (scene.strike->ball != expected.cue_ball) {
        faults.emplace_back("the strike is not on the cue ball");
        return faults;
    }
    const Vec2 there = place_of(scene, expected.cue_ball);
    if (now.legal.place && there != place_of(expected.scene, expected.cue_ball)) {
        if (const auto illegal = find_fault(now.legal, Place{there})) {
            faults.push_back("the cue ball was put where the rules do not allow it (" +
                             std::string(name(illegal->code)) + ")");
            return faults;
        }
        place = Place{there};
        set_xy(expected.scene.balls[expected.cue_ball.value].state.r, there);
    }
    expected.scene.strike = scene.strike;
    expected.scene.id = scene.id;
    if (expected.scene != scene)
        faults.push_back("the scene does not follow from the shots before it: " +
                         first_difference(scene, expected.scene));
    return faults;
}

void check_scene_hash(const ShotRecord& record, Findings& found) {
    const std::uint64_t hash = hash_of(record.scene);
    if (hash != record.scene_hash)
        found.deviations.push_back(differs("scene hash", to_hex(hash), to_hex(record.scene_hash)));
}

}  // namespace

void LogFollower::take(const GameRecord& record, Followed& followed) {
    auto& deviations = followed.found.deviations;
    if (record.game_number != game_number_ + 1)
        deviations.push_back(differs("number", std::to_string(record.game_number),
                                     std::to_string(game_number_ + 1)));
    game_number_ = record.game_number;
    is_state_known_ = true;
    if (!knows_rules()) return;
    if (!match_) {
        begin_match(record.first);
    } else if (match_->now().game.over && match_->next_first() == record.first) {
        agree_to_rematch();
    } else {
        deviations.emplace_back("it does not follow from the game before");
        begin_match(record.first);
    }
}

void LogFollower::agree_to_rematch() {
    const std::uint32_t before = match_->now().game_number;
    for (const Seat seat : kSeats) {
        if (match_->now().game_number == before && !match_->now().consents[seat.value])
            match_->commit(match_->play(seat, Agree{}, at_ms_), at_ms_);
    }
}

void LogFollower::take(const ShotRecord& record, Followed& followed) {
    Findings& found = followed.found;
    check_number(record.shot, found);
    at_ms_ = record.at_ms;
    if (record.game_number != game_number_)
        found.deviations.push_back(
            differs("game", std::to_string(record.game_number), std::to_string(game_number_)));
    edition_of_log_ = evidence_of(record).edition;
    check_scene_hash(record, found);
    if (!match_) {
        check_alone(record, followed);
        if (knows_rules()) found.deviations.emplace_back("no game was begun before it");
        return;
    }
    set_table(record, found);
    if (auto step = play_strike(record, found)) {
        check_step(*std::move(step), record, followed);
    } else {
        check_alone(record, followed);
    }
}

/// Whether the shot's own scene gives what was recorded.
void LogFollower::check_alone(const ShotRecord& record, Followed& followed) const {
    const SimulatedShot shot{record.scene, simulate(record.scene)};
    const ShotEvidence evidence = evidence_of(record);
    const auto compared = compare(shot, evidence, edition_, followed.found);
    followed.shot = {compared.hash, compared.as_recorded};
    if (!compared.as_recorded && !compared.same_edition)
        followed.found.remarks.push_back("played by edition " + std::to_string(evidence.edition) +
                                         " of the physics: " + compared.parting);
}

/// Brings the match to where the shot begins.
void LogFollower::set_table(const ShotRecord& record, Findings& found) {
    std::optional<Place> place;
    const auto faults = chain_faults(match_->now(), record, place);
    if (faults.empty()) {
        if (place) match_->commit(match_->play(record.seat, *place, record.at_ms), record.at_ms);
    } else {
        const GameState& now = match_->now().game;
        const GameState before = state_before(now, record);
        if (is_state_known_) {
            found.deviations.insert(found.deviations.end(), faults.begin(), faults.end());
        } else {
            found.remarks.push_back("of the shot before: " + distance_in_words(now, before));
        }
        const Place there{place_of(record.scene, record.scene.strike->ball)};
        const MadeMove made{record.seat, there, record.at_ms, hash_of(before)};
        match_->commit(match_->recorded(made, {before, std::nullopt, std::nullopt}), record.at_ms);
    }
    is_state_known_ = true;
}

/// The shot by the rules; nothing if they allow none in its direction.
std::optional<MatchStep> LogFollower::play_strike(const ShotRecord& record, Findings& found) {
    const Strike& strike = *record.scene.strike;
    const Stroke stroke{strike.direction, strike.speed, strike.offset, strike.elevation};
    for (const Stroke& tried : {stroke, Stroke{strike.direction, std::nullopt, {}, 0}}) {
        if (match_->find_fault(record.seat, Shoot{tried}, record.at_ms)) continue;
        MatchStep step = match_->play(record.seat, Shoot{tried}, record.at_ms);
        if (step.shot()->simulated.scene.strike != strike)
            found.deviations.emplace_back("the strike is not one that the rules give");
        return step;
    }
    found.deviations.emplace_back("the rules do not allow it");
    return std::nullopt;
}

void LogFollower::check_step(MatchStep step, const ShotRecord& record, Followed& followed) {
    auto& deviations = followed.found.deviations;
    if (step.shot()->simulated.scene.strike != record.scene.strike) {
        check_alone(record, followed);
        match_->commit(std::move(step), record.at_ms);
        return;
    }
    const SimulatedShot& simulated = step.shot()->simulated;
    const ShotEvidence evidence = evidence_of(record);
    const auto compared = compare(simulated, evidence, edition_, followed.found);
    followed.shot = {compared.hash, compared.as_recorded};
    if (compared.as_recorded || compared.same_edition) {
        if (step.ruling() != record.ruling)
            deviations.push_back(
                differs("ruling", in_words(step.ruling()), in_words(record.ruling)));
        match_->commit(std::move(step), record.at_ms);
        return;
    }
    followed.found.remarks.push_back("played by edition " + std::to_string(evidence.edition) +
                                     " of the physics: " + compared.parting);
    is_state_known_ = false;
    MadeMove made = step.made;
    const GameState after = as_ruled(step.after.game, record.ruling);
    made.state = hash_of(after);
    match_->commit(match_->recorded(made, {after, record.ruling, simulated}), record.at_ms);
}

}  // namespace poolhall::protocol
