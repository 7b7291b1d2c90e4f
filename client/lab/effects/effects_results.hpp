#pragma once

#include "client/lab/output/build_info.hpp"
#include "client/lab/statistics/quantiles.hpp"

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

// What `poolhall-lab effects` finds.
namespace poolhall::lab {

/// CPU time, the median of the repeats; instructions where the processor lets them be counted.
struct Price {
    double ns = 0;
    std::optional<double> instructions;
};

/// What shots of one kind cost, on the average.
struct ShotPrices {
    Price per_shot;                      ///< by the event solver
    Price per_event;                     ///< the same, divided by the events
    std::optional<Price> per_ball_step;  ///< semi_implicit at 120 Hz: by ticks and balls; nothing
                                         ///< where that solver does not take the shots
};

struct KernelRow {
    std::string kernel;
    std::string ensemble;
    ShotPrices prices;
    Price by_everything;  ///< the same shots, per shot, in the kernel that has every effect
};

struct EffectRow {
    std::string effect;
    std::string ensemble;
    ShotPrices absent;
    std::optional<ShotPrices> zero;  ///< named without strength
    ShotPrices present;
    /// How far it moves the ball that it moves most from where it would be, m; when the shot that
    /// has it is at rest.
    Spread rest_change;
    double verdict_flips = 0;  ///< share of shots in which other balls go down
};

/// Shares of the shots of one kind of play.
struct EffectShare {
    std::string effect;
    double called_for = 0;  ///< in which it may act
    double acted = 0;       ///< in which it does
};

struct PlayRow {
    std::string kind;
    std::vector<EffectShare> effects;  ///< all that the shots name
    Price per_shot;                    ///< with what each calls for
    Price by_everything;               ///< with all that they name
};

struct EffectsResult {
    std::string command;
    std::uint64_t seed = 0;
    std::size_t shots = 0;  ///< of each row
    bool complete = false;
    BuildInfo build;
    std::vector<KernelRow> kernels;
    std::vector<EffectRow> effects;
    std::vector<PlayRow> play;
};

void print_kernels(std::ostream& out, const std::vector<KernelRow>& rows);
void print_effects(std::ostream& out, const std::vector<EffectRow>& rows);
void print_play(std::ostream& out, const std::vector<PlayRow>& rows);
/// "poolhall.effects/1": client/lab/report/schema/effects.schema.json.
void write_json(std::ostream& out, const EffectsResult& result);
/// A line for each kernel, for each effect absent, of zero strength and present, and for each kind
/// of play proven and by everything.
void write_csv(std::ostream& out, const EffectsResult& result);

}  // namespace poolhall::lab
