#include "client/lab/accuracy/point_errors.hpp"

namespace poolhall::lab {

void PointErrors::add(const ShotErrors& errors, const ShotTrace& trace,
                      std::size_t reference_events) {
    rest_.push_back(errors.rest);
    if (errors.impact) {
        impact_time_.push_back(errors.impact->time);
        impact_place_.push_back(errors.impact->place);
        impact_velocity_.push_back(errors.impact->velocity);
    }
    energy_drift_.push_back(errors.energy_drift);
    horizon_.push_back(errors.horizon);
    kernel_ = trace.kernel;
    events_ += static_cast<double>(trace.events.size());
    ticks_ += static_cast<double>(trace.ticks);
    reference_events_ += static_cast<double>(reference_events);
    matching_events_ += errors.matching_events;
    verdict_flips_ += errors.verdict_flips ? 1 : 0;
    missed_ += errors.missed;
    invented_ += errors.invented;
}

void PointErrors::add_winner(bool flips) {
    ++winners_;
    winner_flips_ += flips ? 1 : 0;
}

void PointErrors::write(AccuracyPoint& point) const {
    const auto shots = static_cast<double>(rest_.size());
    point.kernel = kernel_;
    point.cost.ticks = ticks_ / shots;
    point.cost.events = events_ / shots;
    point.rest_error = *spread_of(rest_);
    point.impact_time_error = spread_of(impact_time_);
    point.impact_place_error = spread_of(impact_place_);
    point.impact_velocity_error = spread_of(impact_velocity_);
    point.energy_drift = *spread_of(energy_drift_);
    point.matching_share = reference_events_ > 0 ? matching_events_ / reference_events_ : 1;
    point.horizon_median = spread_of(horizon_)->median;
    point.verdict_flips = verdict_flips_ / shots;
    if (winners_ > 0) point.winner_flips = winner_flips_ / winners_;
    point.missed = missed_ / shots;
    point.invented = invented_ / shots;
}

}  // namespace poolhall::lab
