#include "protocol/replay/shot_check.hpp"

#include "protocol/text.hpp"
#include "protocol/wire/game_fields.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace poolhall::protocol {

namespace {

/// Version 1 does not name the edition that made it: there was one.
constexpr std::uint32_t kEditionOfVersion1 = 1;

/// The shortest text that reads back to the same double.
std::string exact(double number) {
    return nlohmann::json(number).dump();
}

std::string first_json_difference(const nlohmann::json& found, const nlohmann::json& expected) {
    const nlohmann::json differences = nlohmann::json::diff(found, expected);
    if (differences.empty()) return "the bits of a number";
    const auto pointer = differences[0].at("path").get<std::string>();
    const nlohmann::json::json_pointer place(pointer);
    const auto at = [&place](const nlohmann::json& json) {
        return json.contains(place) ? json.at(place).dump(-1, ' ', true) : std::string("nothing");
    };
    return differs(pointer, at(found), at(expected));
}

template <class Codec, class T>
std::string first_difference_of(const Codec& codec, const T& found, const T& expected) {
    return first_json_difference(codec.write(found, Encoding::kJson),
                                 codec.write(expected, Encoding::kJson));
}

/// Where the two event lists part, as far as the recorded times tell.
std::string first_diverging_event(const ShotTrace& trace, const ShotEvidence& shot) {
    const auto& events = trace.events;
    const auto& times = shot.event_times;
    for (std::size_t i = 0; i < std::min(events.size(), times.size()); ++i) {
        if (events[i].t == times[i]) continue;
        return "first at event " + std::to_string(i + 1) + " (" +
               std::string(name(events[i].kind)) + ") at " + exact(events[i].t) + " s expected " +
               exact(times[i]) + " s";
    }
    if (events.size() != shot.event_count)
        return differs("events", std::to_string(events.size()), std::to_string(shot.event_count));
    return times.empty() ? "no event times were recorded" : "the times of all events agree";
}

void check_solver(const SimulatedShot& simulated, const ShotEvidence& shot, Findings& found) {
    const std::string_view solver = name(simulated.trace.solver);
    if (shot.solver == solver) return;
    if (find<SolverKind>(shot.solver)) {
        found.deviations.push_back(differs("solver", solver, shot.solver));
        return;
    }
    found.remarks.push_back("there is no solver " + shown(shot.solver) + " here: simulated by " +
                            std::string(solver));
}

bool is_kernel(std::string_view kernel) {
    const auto names = kernel_names();
    return std::find(names.begin(), names.end(), kernel) != names.end();
}

/// The shot by the recorded kernel. Which one is chosen may change from version to version; all
/// that cover a scene give the same.
ShotTrace trace_by_kernel(const SimulatedShot& simulated, const ShotEvidence& shot,
                          bool same_edition, Findings& found) {
    ShotTrace trace = simulated.trace;
    if (shot.kernel == trace.kernel) return trace;
    if (!is_kernel(shot.kernel)) {
        found.remarks.push_back("there is no kernel " + shown(shot.kernel) +
                                " here: simulated by " + std::string(trace.kernel));
    } else if (!simulate_by(shot.kernel, simulated.scene, 0, trace)) {
        auto& clauses = same_edition ? found.deviations : found.remarks;
        clauses.push_back("kernel " + shot.kernel + " does not cover the scene, " +
                          std::string(trace.kernel) + " does");
    }
    return trace;
}

void check_result(const ShotTrace& trace, const ShotEvidence& shot, const std::string& parting,
                  Findings& found) {
    if (trace.hash != shot.trace) {
        found.deviations.push_back(differs("hash", to_hex(trace.hash), to_hex(shot.trace)) + ", " +
                                   parting);
    } else if (trace.events.size() != shot.event_count) {
        found.deviations.push_back(parting);
    }
    if (trace.duration != shot.duration)
        found.deviations.push_back(
            differs("duration", exact(trace.duration), exact(shot.duration)));
}

const SceneBall* ball_of(const GameState& state, std::string_view id) {
    const auto ball = find_ball(state.scene, id);
    return ball ? &state.scene.balls[ball->value] : nullptr;
}

/// A ball that only one of the states has; empty if there is none.
std::string lone_ball(const GameState& a, const GameState& b, const std::string& where) {
    for (const SceneBall& ball : a.scene.balls)
        if (ball_of(b, ball.id) == nullptr)
            return "ball " + shown(ball.id) + " is on the table only " + where;
    return {};
}

}  // namespace

std::string differs(std::string_view what, std::string_view found, std::string_view expected) {
    std::string text(what);
    return text.append(" ").append(found).append(" expected ").append(expected);
}

std::string first_difference(const Scene& found, const Scene& expected) {
    return first_difference_of(wire::SceneCodec{}, found, expected);
}

std::string first_difference(const GameState& found, const GameState& expected) {
    return first_difference_of(wire::GameStateCodec{}, found, expected);
}

std::string first_difference(const Move& found, const Move& expected) {
    return first_difference_of(wire::Tagged{}, found, expected);
}

std::string in_words(const std::optional<Ruling>& ruling) {
    if (!ruling) return "none";
    std::string text(name(ruling->verdict));
    text += " by seat " + std::to_string(ruling->shooter.value) + ", next " +
            std::to_string(ruling->next.value);
    text += ruling->winner ? ", won by " + std::to_string(ruling->winner->value) : ", nobody won";
    return text + ", decided at " + exact(ruling->decided_at) + " s";
}

std::string distance_in_words(const GameState& here, const GameState& recorded) {
    if (auto lone = lone_ball(recorded, here, "in the record"); !lone.empty()) return lone;
    if (auto lone = lone_ball(here, recorded, "here"); !lone.empty()) return lone;
    double farthest = 0;
    std::string id;
    for (const SceneBall& ball : recorded.scene.balls) {
        const double distance = norm(ball.state.r - ball_of(here, ball.id)->state.r);
        if (distance <= farthest) continue;
        farthest = distance;
        id = ball.id;
    }
    if (farthest == 0) return "same final states";
    constexpr double kMmPerMetre = 1000;
    std::array<char, 32> millimetres{};
    std::snprintf(millimetres.data(), millimetres.size(), "%.3g", farthest * kMmPerMetre);
    return "final states up to " + std::string(millimetres.data()) + " mm apart (ball " +
           shown(id) + ")";
}

ShotEvidence evidence_of(const ShotRecord& shot) {
    ShotEvidence evidence;
    evidence.shot = shot.shot;
    evidence.edition = kEditionOfVersion1;
    evidence.solver = name(shot.scene.solver.kind);
    evidence.kernel = shot.kernel;
    evidence.trace = shot.final_hash;
    evidence.duration = shot.duration;
    evidence.event_count = shot.event_count;
    evidence.event_times = shot.event_times;
    return evidence;
}

ShotComparison compare(const SimulatedShot& simulated, const ShotEvidence& evidence,
                       std::uint32_t edition, Findings& found) {
    check_solver(simulated, evidence, found);
    ShotComparison comparison;
    comparison.same_edition = evidence.edition == edition;
    const ShotTrace trace = trace_by_kernel(simulated, evidence, comparison.same_edition, found);
    comparison.hash = trace.hash;
    comparison.as_recorded = trace.hash == evidence.trace;
    comparison.parting = first_diverging_event(trace, evidence);
    if (comparison.same_edition) check_result(trace, evidence, comparison.parting, found);
    return comparison;
}

}  // namespace poolhall::protocol
