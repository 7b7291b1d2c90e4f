#pragma once

#include "shared/physics/effects/all_effects.hpp"
#include "shared/physics/effects/effect_set.hpp"

#include <string_view>
#include <tuple>

namespace poolhall {

// The closed list of kernels, cheapest first; the first that covers a scene simulates it. Models of
// impacts (ball_ball, rail) are chosen at each impact: that costs a branch in what is rare, and no
// instruction in a ball's step.

struct OpenCloth : EffectSet<> {
    using EffectSet::EffectSet;
    static constexpr std::string_view kName = "open_cloth";
};

struct RailsOnly : EffectSet<Rails> {
    using EffectSet::EffectSet;
    static constexpr std::string_view kName = "rails";
};

struct DragRails : EffectSet<LinearDrag, Rails> {
    using EffectSet::EffectSet;
    static constexpr std::string_view kName = "drag_rails";
};

struct DragRailsPockets : EffectSet<LinearDrag, Rails, EndGamePockets> {
    using EffectSet::EffectSet;
    static constexpr std::string_view kName = "drag_rails_pockets";
};

struct Roll : EffectSet<Rolling, Rails> {
    using EffectSet::EffectSet;
    static constexpr std::string_view kName = "roll";
};

struct SlideRoll : EffectSet<Sliding, Rolling, Rails, PocketCircles> {
    using EffectSet::EffectSet;
    static constexpr std::string_view kName = "slide_roll";
};

struct SlideRollSpin : EffectSet<Sliding, Rolling, SpinDecay, Rails, PocketCircles> {
    using EffectSet::EffectSet;
    static constexpr std::string_view kName = "slide_roll_spin";
};

struct SlideRollSpinEndGame : EffectSet<Sliding, Rolling, SpinDecay, Rails, EndGamePockets> {
    using EffectSet::EffectSet;
    static constexpr std::string_view kName = "slide_roll_spin_end_game";
};

struct SlideRollSpinMouths : EffectSet<Sliding, Rolling, SpinDecay, PoolMouths> {
    using EffectSet::EffectSet;
    static constexpr std::string_view kName = "slide_roll_spin_mouths";
};

struct Everything : SetOf<AllEffects> {
    using EffectSet::EffectSet;
    static constexpr std::string_view kName = "everything";
};

using KernelList = std::tuple<OpenCloth, RailsOnly, DragRails, DragRailsPockets, Roll, SlideRoll,
                              SlideRollSpin, SlideRollSpinEndGame, SlideRollSpinMouths, Everything>;

}  // namespace poolhall
