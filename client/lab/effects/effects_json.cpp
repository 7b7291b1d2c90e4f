#include "client/lab/effects/effects_results.hpp"
#include "client/lab/output/result_json.hpp"

namespace poolhall::lab {

namespace {

using lab::json_of;

Json json_of(const Price& price) {
    return {{"ns", price.ns}, {"instructions", json_of(price.instructions)}};
}

Json json_of(const std::optional<Price>& price) {
    return price ? json_of(*price) : Json();
}

Json json_of(const KernelRow& row) {
    return {{"kernel", row.kernel},
            {"ensemble", row.ensemble},
            {"per_ball_step", json_of(row.prices.per_ball_step)},
            {"per_event", json_of(row.prices.per_event)},
            {"per_shot", json_of(row.prices.per_shot)},
            {"per_shot_by_everything", json_of(row.by_everything)}};
}

Json variant_of(const ShotPrices& prices) {
    const auto& step = prices.per_ball_step;
    return {{"ns_per_shot", prices.per_shot.ns},
            {"instructions_per_shot", json_of(prices.per_shot.instructions)},
            {"ns_per_event", prices.per_event.ns},
            {"instructions_per_event", json_of(prices.per_event.instructions)},
            {"ns_per_ball_step", step ? Json(step->ns) : Json()},
            {"instructions_per_ball_step", step ? json_of(step->instructions) : Json()}};
}

Json json_of(const EffectRow& row) {
    return {{"effect", row.effect},
            {"ensemble", row.ensemble},
            {"absent", variant_of(row.absent)},
            {"zero", row.zero ? variant_of(*row.zero) : Json()},
            {"present", variant_of(row.present)},
            {"rest_change", json_of(std::optional(row.rest_change))},
            {"verdict_flips", row.verdict_flips}};
}

Json json_of(const PlayRow& row) {
    Json effects = Json::array();
    for (const EffectShare& share : row.effects)
        effects.push_back(
            {{"effect", share.effect}, {"called_for", share.called_for}, {"acted", share.acted}});
    return {{"kind", row.kind},
            {"per_shot", json_of(row.per_shot)},
            {"per_shot_by_everything", json_of(row.by_everything)},
            {"effects", effects}};
}

template <class Row>
Json json_of(const std::vector<Row>& rows) {
    Json json = Json::array();
    for (const Row& row : rows)
        json.push_back(json_of(row));
    return json;
}

}  // namespace

void write_json(std::ostream& out, const EffectsResult& result) {
    const Json json{{"schema", "poolhall.effects/1"},
                    {"command", result.command},
                    {"seed", result.seed},
                    {"shots", result.shots},
                    {"complete", result.complete},
                    {"build", json_of(result.build)},
                    {"kernels", json_of(result.kernels)},
                    {"effects", json_of(result.effects)},
                    {"play", json_of(result.play)}};
    out << json.dump(1) << '\n';
}

}  // namespace poolhall::lab
