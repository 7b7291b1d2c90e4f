#include "client/compare/comparison.hpp"
#include "client/lab/accuracy/results.hpp"
#include "client/lab/output/result_json.hpp"
#include "shared/physics/scene/trace.hpp"
#include "shared/physics/simulate.hpp"

namespace poolhall::lab {

namespace {

using lab::json_of;

using compare::label;

Json json_of(const ShotCost& cost) {
    return {{"ns", cost.ns},
            {"instructions", json_of(cost.instructions)},
            {"worst_tick_ns", cost.worst_tick_ns},
            {"ticks", cost.ticks},
            {"events", cost.events}};
}

Json json_of(const AccuracyPoint& point) {
    const bool ticks = has_ticks(point.solver.kind);
    return {{"solver", name(point.solver.kind)},
            {"hz", ticks ? Json(point.solver.hz) : Json()},
            {"label", label(point.solver)},
            {"kernel", point.kernel},
            {"cost", json_of(point.cost)},
            {"rest_error", json_of(point.rest_error)},
            {"impact_time_error", json_of(point.impact_time_error)},
            {"impact_place_error", json_of(point.impact_place_error)},
            {"impact_velocity_error", json_of(point.impact_velocity_error)},
            {"energy_drift", json_of(point.energy_drift)},
            {"matching_events",
             {{"share", point.matching_share}, {"horizon_median", point.horizon_median}}},
            {"verdict_flips", point.verdict_flips},
            {"winner_flips", json_of(point.winner_flips)},
            {"missed", point.missed},
            {"invented", point.invented}};
}

Json json_of(const OrderRow& row) {
    Json json{{"solver", name(row.solver)}, {"quantity", row.quantity}};
    json["order"] = row.order ? Json(row.order->order) : Json();
    json["low"] = row.order ? Json(row.order->low) : Json();
    json["high"] = row.order ? Json(row.order->high) : Json();
    json["points"] = row.order ? row.order->points : 0;
    json["expected"] = row.expected;
    if (!row.note.empty()) json["note"] = row.note;
    return json;
}

Json json_of(const ErrorInTime& errors) {
    return {{"label", label(errors.solver)},
            {"t", errors.t},
            {"median", errors.median},
            {"p90", errors.p90}};
}

Json json_of(const Tunnelling& one) {
    return {{"label", label(one.solver)}, {"speed", one.speed}, {"missed", one.missed}};
}

Json json_of(const CrowdCosts& one) {
    return {{"label", label(one.solver)}, {"balls", one.balls}, {"ns", one.ns}};
}

Json json_of(const EnsembleResult& result);

template <class Item>
Json json_of(const std::vector<Item>& items) {
    Json json = Json::array();
    for (const Item& item : items)
        json.push_back(json_of(item));
    return json;
}

Json json_of(const EnsembleResult& result) {
    return {{"name", result.name},
            {"title", result.title},
            {"shots", result.shots},
            {"reference", result.reference},
            {"reference_error", result.reference_error},
            {"points", json_of(result.points)},
            {"orders", json_of(result.orders)},
            {"error_in_time", json_of(result.error_in_time)}};
}

}  // namespace

void write_json(std::ostream& out, const AccuracyResult& result) {
    const Json json{{"schema", "poolhall.accuracy/1"},
                    {"command", result.command},
                    {"seed", result.seed},
                    {"quick", result.quick},
                    {"complete", result.complete},
                    {"seconds", result.seconds},
                    {"build", json_of(result.build)},
                    {"ensembles", json_of(result.ensembles)},
                    {"tunnelling", json_of(result.tunnelling)},
                    {"crowds", json_of(result.crowds)}};
    out << json.dump(1) << '\n';
}

}  // namespace poolhall::lab
