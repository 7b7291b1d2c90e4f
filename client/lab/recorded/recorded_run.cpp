#include "client/lab/recorded/recorded_run.hpp"

#include <chrono>

namespace poolhall::lab {

namespace {

TableConstants constants_of(RailModel model, double e, double nose_of_diameter) {
    constexpr double kFriction = 0.2;
    TableConstants constants;
    constants.ball_ball.model = BallBallModel::kFriction;
    constants.rail = {model, e, kFriction, nose_of_diameter * 2 * kRecordedBall.radius};
    return constants;
}

}  // namespace

std::vector<RecordedModel> recorded_models(std::size_t threads) {
    TableFitPlan han;
    han.threads = threads;
    // A hit of Mathavan's rail costs a hundred of Han's.
    TableFitPlan mathavan = han;
    mathavan.first = {60, 10, 1};
    mathavan.last = {200, 24, 3};
    mathavan.evaluations = 60;
    mathavan.rounds = 1;
    TableConstants by_speed = constants_of(RailModel::kHan2005, 0.85, 0.6);
    by_speed.rail.e_by_speed = RestitutionBySpeed{.e = 0.85, .best_speed = 1.5, .softening = 0.05};
    return {{"Han", constants_of(RailModel::kHan2005, 0.85, 0.6), han},
            {"Han, e(v)", by_speed, han},
            {"Mathavan", constants_of(RailModel::kMathavan2010Fast, 0.9, 0.7), mathavan}};
}

std::optional<RecordedResult> run_recorded(const std::vector<RecordedShot>& shots,
                                           const RecordedModel& model, Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<RecordedShot> odd;
    std::vector<RecordedShot> even;
    for (std::size_t i = 0; i < shots.size(); ++i)
        (i % 2 == 0 ? odd : even).push_back(shots[i]);
    const auto fit = [&](const std::vector<RecordedShot>& some, const TableConstants& constants) {
        return fit_shots(some, constants, model.plan.last, model.plan.threads, progress);
    };
    const auto unfitted = fit(even, model.start);
    if (!unfitted) return std::nullopt;
    auto constants = fit_constants(odd, model.start, model.plan, progress);
    if (!constants) return std::nullopt;
    const auto on_odd = fit(odd, *constants);
    const auto on_even = fit(even, *constants);
    if (!on_odd || !on_even) return std::nullopt;
    RecordedResult result{model.name, {}, *unfitted, *on_odd, *on_even};
    for (const FittedConstant& constant : fitted_constants(model.start.rail))
        result.constants.emplace_back(constant.name, *constant.place(*constants));
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    result.seconds = passed.count();
    return result;
}

}  // namespace poolhall::lab
