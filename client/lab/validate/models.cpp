#include "client/lab/validate/models.hpp"

#include "client/lab/validate/cases.hpp"

namespace poolhall::lab {

namespace {

/// For balls of that radius, m. Han's nose at 64 % of their diameter, the default; Mathavan's at 70
/// %, as M10 has it.
std::vector<NoseModel> noses_for(double radius) {
    return {{"Han, e 0.85, mu 0.2", {RailModel::kHan2005, 0.85, 0.2, 1.28 * radius}},
            {"Mathavan, e 0.98, mu 0.14", {RailModel::kMathavan2010, 0.98, 0.14, 1.4 * radius}}};
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
    return {{"elastic", {}},
            {"e 0.89, mu 0.05", with_friction(0.89, 0.05)},
            {"e 0.95, mu 0.05", with_friction(0.95, 0.05)},
            {"e 0.95, Alciatore's law", with_alciatores_law(0.95)}};
}

std::vector<BallModel> throwing_models() {
    std::vector<BallModel> models = ball_models();
    models.erase(models.begin());
    return models;
}

std::vector<NoseModel> snooker_noses() {
    return noses_for(kSnookerBall.radius);
}

std::vector<NoseModel> pool_noses() {
    return noses_for(BallSpec{}.radius);
}

std::vector<NoseModel> carom_noses() {
    return noses_for(kCaromBall.radius);
}

}  // namespace poolhall::lab
