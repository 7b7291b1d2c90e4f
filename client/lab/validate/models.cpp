#include "client/lab/validate/models.hpp"

#include "client/lab/validate/cases.hpp"
#include "shared/physics/effects/presets.hpp"

namespace poolhall::lab {

namespace {

/// For balls of that radius, m. Han's nose at 64 % of their diameter, the default of older scenes;
/// Mathavan's at 70 %, as M10 has it; and what the preset of such a table says.
std::vector<NoseModel> noses_for(double radius, EffectsPreset preset) {
    return {{"Han, e 0.85, mu 0.2", {RailModel::kHan2005, 0.85, 0.2, 1.28 * radius}},
            {"Mathavan, e 0.98, mu 0.14", {RailModel::kMathavan2010, 0.98, 0.14, 1.4 * radius}},
            {"preset: Mathavan, e(v)", preset_value(preset).rail}};
}

BallBallSpec with_cloth(BallBallSpec spec) {
    spec.model = BallBallModel::kMathavan2014;
    return spec;
}

}  // namespace

BallBallSpec with_friction(double e, double mu) {
    BallBallSpec spec;
    spec.model = BallBallModel::kFriction;
    spec.e = e;
    spec.mu = mu;
    return spec;
}

BallBallSpec with_alciatores_law(double e) {
    BallBallSpec spec = with_friction(e, 0);
    spec.friction_by_speed = FrictionBySpeed{};
    return spec;
}

std::vector<BallModel> ball_models() {
    return {{"elastic", {.model = BallBallModel::kElastic}},
            {"e 0.89, mu 0.05", with_friction(0.89, 0.05)},
            {"e 0.95, mu 0.05", with_friction(0.95, 0.05)},
            {"e 0.95, Alciatore's law", with_alciatores_law(0.95)},
            {"mathavan2014, e 0.89, mu 0.05", with_cloth(with_friction(0.89, 0.05))},
            {"mathavan2014, e 0.93, Alciatore's law", with_cloth(with_alciatores_law(0.93))},
            {"mathavan2014, e 0.95, Alciatore's law", with_cloth(with_alciatores_law(0.95))}};
}

std::vector<BallModel> throwing_models() {
    std::vector<BallModel> models = ball_models();
    models.erase(models.begin());
    return models;
}

std::vector<NoseModel> snooker_noses() {
    return noses_for(kSnookerBall.radius, EffectsPreset::kSnooker);
}

std::vector<NoseModel> pool_noses() {
    return noses_for(BallSpec{}.radius, EffectsPreset::kWorsted);
}

std::vector<NoseModel> carom_noses() {
    return noses_for(kCaromBall.radius, EffectsPreset::kHeatedCarom);
}

}  // namespace poolhall::lab
