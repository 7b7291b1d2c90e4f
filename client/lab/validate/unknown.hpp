#pragma once

#include "client/lab/statistics/quantiles.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// What nobody knows of a real shot, however well it is computed.
namespace poolhall::lab {

/// How far the shots of an ensemble come to rest from where they would, of each shot the ball that
/// is farthest off; m. By the event solver, so that solvers have no part in it.
struct Unknown {
    std::string ensemble;
    std::size_t shots = 0;
    Spread placement;     ///< every ball put down up to 0.1 mm off, and nothing else
    Spread coefficients;  ///< cloth, balls and rails within the spread of their measurements
};

/// How long the events of a shot are those of the same shot with its balls put down a little off.
struct HorizonByError {
    std::string ensemble;
    std::size_t shots = 0;
    std::vector<double> input_error;  ///< of each ball's place, m
    std::vector<double> horizon;      ///< median over shots, s
    std::vector<double> duration;     ///< median over shots of the whole, s
};

/// Of every ensemble of `poolhall-lab accuracy`, on so many shots of each.
[[nodiscard]] std::vector<Unknown> find_unknowns(std::uint64_t seed, std::size_t shots);
/// Of those that break a rack.
[[nodiscard]] std::vector<HorizonByError> find_horizons(std::uint64_t seed, std::size_t shots);

}  // namespace poolhall::lab
