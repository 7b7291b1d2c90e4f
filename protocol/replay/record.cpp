#include "protocol/replay/record.hpp"

namespace poolhall::protocol {

std::string_view kind_of(const ReplayRecord& record) {
    return std::visit([](const auto& alternative) { return alternative.kKind; }, record);
}

ShotRecord shot_record(const ShotOutcome& outcome) {
    ShotRecord record;
    record.seat = outcome.ruling.shooter;
    record.scene = outcome.scene;
    record.scene_hash = hash_of(outcome.scene);
    record.kernel = outcome.trace.kernel;
    record.final_hash = outcome.trace.hash;
    record.duration = outcome.trace.duration;
    record.event_count = static_cast<std::uint32_t>(outcome.trace.events.size());
    record.ruling = outcome.ruling;
    if (outcome.trace.events.size() > kMaxEventTimes) return record;
    for (const ShotEvent& event : outcome.trace.events)
        record.event_times.push_back(event.t);
    return record;
}

}  // namespace poolhall::protocol
