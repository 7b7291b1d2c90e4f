#include "client/replay/verifier.hpp"

#include "protocol/codec/scene_json.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

namespace poolhall::client {

namespace {

using protocol::ShotRecord;

/// The shortest text that reads back to the same double.
std::string exact(double number) {
    return nlohmann::json(number).dump();
}

std::string differs(std::string_view what, std::string_view found, std::string_view expected) {
    std::string text(what);
    return text.append(" ").append(found).append(" expected ").append(expected);
}

/// Where the two event lists part, as far as the recorded times tell.
std::string first_diverging_event(const ShotTrace& trace, const ShotRecord& shot) {
    const auto& events = trace.events;
    const auto& times = shot.event_times;
    for (std::size_t i = 0; i < std::min(events.size(), times.size()); ++i) {
        if (events[i].t == times[i]) continue;
        return "first at event " + std::to_string(i + 1) + " (" +
               std::string(name(events[i].kind)) + ") at " + exact(events[i].t) + " s expected " +
               exact(times[i]) + " s";
    }
    if (events.size() != shot.event_count) {
        return differs("events", std::to_string(events.size()), std::to_string(shot.event_count));
    }
    return times.empty() ? "no event times were recorded" : "the times of all events agree";
}

void check_result(const ShotTrace& trace, const ShotRecord& shot, std::vector<std::string>& found) {
    const std::uint64_t scene_hash = hash_of(shot.scene);
    if (scene_hash != shot.scene_hash) {
        found.push_back(differs("scene hash", to_hex(scene_hash), to_hex(shot.scene_hash)));
    }
    if (trace.hash != shot.final_hash) {
        found.push_back(differs("hash", to_hex(trace.hash), to_hex(shot.final_hash)) + ", " +
                        first_diverging_event(trace, shot));
    } else if (trace.events.size() != shot.event_count) {
        found.push_back(first_diverging_event(trace, shot));
    }
    if (trace.duration != shot.duration) {
        found.push_back(differs("duration", exact(trace.duration), exact(shot.duration)));
    }
}

/// Plays the shot by the recorded kernel. Which one is chosen may change from version to version;
/// all that cover a scene give the same.
ShotTrace play_again(const ShotRecord& shot, std::vector<std::string>& found) {
    ShotTrace trace;
    if (!simulate_by(shot.kernel, shot.scene, 0, trace)) {
        simulate(shot.scene, 0, trace);
        found.push_back("kernel " + shot.kernel + " does not cover the scene, " +
                        std::string(trace.kernel) + " does");
    }
    return trace;
}

/// The first place where two JSON values differ, with both values; they must differ.
std::string first_difference(const nlohmann::json& recorded, const nlohmann::json& expected) {
    const auto pointer =
        nlohmann::json::diff(recorded, expected).at(0).at("path").get<std::string>();
    const nlohmann::json::json_pointer place(pointer);
    const auto at = [&place](const nlohmann::json& json) {
        return json.contains(place) ? json.at(place).dump() : std::string("nothing");
    };
    return differs(pointer, at(recorded), at(expected));
}

std::string text_of(const Ruling& ruling) {
    std::string text(name(ruling.verdict));
    text += " by seat " + std::to_string(ruling.shooter.value) + ", next " +
            std::to_string(ruling.next.value);
    text += ruling.winner ? ", won by " + std::to_string(ruling.winner->value) : ", nobody won";
    return text + ", decided at " + exact(ruling.decided_at) + " s";
}

bool has_same_balls(const Scene& a, const Scene& b) {
    return std::ranges::equal(a.balls, b.balls, {}, &SceneBall::id, &SceneBall::id);
}

/// Moves the cue ball to where the shot was played from, if a player may do that now. Why the rules
/// refuse that place.
std::optional<Illegal> follow_placement(const Ruleset& rules, const Scene& played,
                                        GameState& state) {
    const Vec2 here = xy(state.scene.balls[state.cue_ball.value].state.r);
    const Vec2 there = xy(played.balls[state.cue_ball.value].state.r);
    const bool moved = here != there && rules.nearest_placement(state, there).has_value();
    return moved ? rules.place_cue_ball(state, there) : std::nullopt;
}

}  // namespace

std::optional<ShotReport> Verifier::follow(const protocol::ReplayRecord& record) {
    if (const auto* match = std::get_if<protocol::MatchRecord>(&record)) begin_match(*match);
    if (const auto* game = std::get_if<protocol::GameRecord>(&record)) begin_game(*game);
    const auto* shot = std::get_if<ShotRecord>(&record);
    if (shot == nullptr) return std::nullopt;
    return check(*shot);
}

void Verifier::begin_match(const protocol::MatchRecord& match) {
    rules_ = find_ruleset(match.game);
    settings_ = match.settings.value_or(GameSettings{});
    if (rules_ != nullptr) settings_fault_ = poolhall::check(*rules_, settings_);
}

void Verifier::begin_game(const protocol::GameRecord& game) {
    game_number_ = game.game_number;
    game_shots_ = 0;
    if (rules_ != nullptr) state_ = new_game(*rules_, game.first, settings_);
}

ShotReport Verifier::check(const ShotRecord& shot) {
    ShotReport report;
    report.shot = shot.shot;
    const ShotTrace trace = play_again(shot, report.divergences);
    report.hash = trace.hash;
    if (shot.shot != ++shots_) {
        report.divergences.push_back(
            differs("number", std::to_string(shot.shot), std::to_string(shots_)));
        shots_ = shot.shot;
    }
    if (shot.game_number != game_number_) {
        report.divergences.push_back(
            differs("game", std::to_string(shot.game_number), std::to_string(game_number_)));
    }
    check_result(trace, shot, report.divergences);
    if (rules_ != nullptr) check_rules(shot, report.divergences);
    ++game_shots_;
    return report;
}

void Verifier::check_rules(const ShotRecord& shot, Divergences& found) {
    if (const auto fault = std::exchange(settings_fault_, std::nullopt))
        found.push_back("the match's settings cannot be played: " + fault->pointer + " " +
                        fault->reason);
    check_chain(shot, found);
    const GameState before = state_before(shot);
    const ShotOutcome outcome = rules_->play(before, {shot.scene.strike->direction});
    if (outcome.scene.strike != shot.scene.strike) {
        found.push_back("the strike is not one that the rules give");
    } else if (outcome.ruling != shot.ruling) {
        found.push_back("ruling " + text_of(outcome.ruling) + " expected " + text_of(shot.ruling));
    }
    state_ = outcome.state;
}

/// Whether the scene is what the records before it lead to.
void Verifier::check_chain(const ShotRecord& shot, Divergences& found) {
    if (!state_) {
        found.emplace_back("no game was begun before it");
        return;
    }
    if (state_->over) found.emplace_back("the game was over before it");
    if (state_->turn != shot.seat) {
        found.push_back(differs("shot by seat", std::to_string(shot.seat.value),
                                std::to_string(state_->turn.value)));
    }
    GameState expected = *state_;
    if (!has_same_balls(expected.scene, shot.scene)) {
        found.emplace_back("the balls on the table are not those that the shots before it left");
        return;
    }
    if (shot.scene.strike->ball != expected.cue_ball) {
        found.emplace_back("the strike is not on the cue ball");
        return;
    }
    if (const auto illegal = follow_placement(*rules_, shot.scene, expected)) {
        found.push_back("the cue ball was put where the rules do not allow it (" +
                        std::string(name(*illegal)) + ")");
        return;
    }
    expected.scene.strike = shot.scene.strike;
    expected.scene.id = shot.scene.id;  // a label
    if (expected.scene == shot.scene) return;
    found.push_back(
        "the scene does not follow from the shots before it: " +
        first_difference(protocol::to_json(shot.scene), protocol::to_json(expected.scene)));
}

/// The game as the record has it.
GameState Verifier::state_before(const ShotRecord& shot) const {
    GameState state;
    state.scene = shot.scene;
    state.scene.strike.reset();
    state.cue_ball = shot.scene.strike->ball;
    state.turn = shot.seat;
    state.shots = game_shots_;
    return state;
}

}  // namespace poolhall::client
