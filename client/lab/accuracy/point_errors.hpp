#pragma once

#include "client/lab/accuracy/results.hpp"
#include "client/lab/accuracy/shot_errors.hpp"

#include <vector>

namespace poolhall::lab {

/// Gathers the errors of one solver's shots.
class PointErrors {
  public:
    /// `reference_events` is what errors.matching_events is a part of.
    void add(const ShotErrors& errors, const ShotTrace& trace, std::size_t reference_events);
    /// Where the ensemble has winners.
    void add_winner(bool flips);

    /// Fills in all but `solver` and what a shot costs in time.
    void write(AccuracyPoint& point) const;

  private:
    std::vector<double> rest_;
    std::vector<double> impact_time_;
    std::vector<double> impact_place_;
    std::vector<double> impact_velocity_;
    std::vector<double> energy_drift_;
    std::vector<double> horizon_;
    std::string kernel_;
    double events_ = 0;
    double ticks_ = 0;
    double reference_events_ = 0;
    double matching_events_ = 0;
    double verdict_flips_ = 0;
    double winners_ = 0;
    double winner_flips_ = 0;
    double missed_ = 0;
    double invented_ = 0;
};

}  // namespace poolhall::lab
