#include "protocol/replay/record.hpp"

#include "shared/physics/edition.hpp"

namespace poolhall::protocol {

std::string_view kind_of(const ReplayRecord& record) {
    return std::visit([](const auto& alternative) { return alternative.kKind; }, record);
}

namespace {

ShotEvidence evidence_of(const ShotTaken& shot) {
    const ShotTrace& trace = shot.simulated.trace;
    ShotEvidence evidence;
    evidence.shot = shot.shot;
    evidence.edition = kPhysicsEdition;
    evidence.solver = name(trace.solver);
    evidence.kernel = trace.kernel;
    evidence.effects = analysis::effect_uses(shot.simulated.scene, trace);
    evidence.trace = trace.hash;
    evidence.duration = trace.duration;
    evidence.event_count = static_cast<std::uint32_t>(trace.events.size());
    if (trace.events.size() > kMaxEventTimes) return evidence;
    for (const ShotEvent& event : trace.events)
        evidence.event_times.push_back(event.t);
    return evidence;
}

}  // namespace

MoveRecord move_record(const MatchStep& step) {
    MoveRecord record;
    record.seat = step.made.seat;
    record.move = step.made.move;
    record.state = step.after.game;
    record.state_hash = step.made.state;
    record.ruling = step.ruling();
    if (const ShotTaken* shot = step.shot()) record.shot = evidence_of(*shot);
    record.at_ms = step.made.at_ms;
    return record;
}

}  // namespace poolhall::protocol
