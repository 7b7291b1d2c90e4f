#pragma once

#include "shared/physics/effects/end_game_pockets.hpp"
#include "shared/physics/effects/linear_drag.hpp"
#include "shared/physics/effects/rails.hpp"

#include <string_view>
#include <tuple>
#include <type_traits>

namespace poolhall {

/// Every effect that there is. A new one is one file, one line here, and a kernel with it below.
using AllEffects = std::tuple<LinearDrag, Rails, EndGamePockets>;

/// A set of effects chosen at compile time. An effect is a class that is made from a Scene, says
/// `called_for(scene)`, and has the hooks that the solvers ask for with `if constexpr
/// (Set::template kHas<Effect>)`; one that is not in the set leaves no instruction behind.
template <class... Effect>
class EffectSet {
  public:
    explicit EffectSet(const Scene& scene) : effects_(Effect(scene)...) {}

    template <class Wanted>
    static constexpr bool kHas = (std::is_same_v<Wanted, Effect> || ...);

    template <class Wanted>
    [[nodiscard]] const Wanted& effect() const {
        return std::get<Wanted>(effects_);
    }

    /// True if every effect that the scene calls for is in the set.
    [[nodiscard]] static bool covers(const Scene& scene) {
        return covers(scene, std::type_identity<AllEffects>{});
    }

  private:
    template <class... Any>
    static bool covers(const Scene& scene, std::type_identity<std::tuple<Any...>>) {
        return ((kHas<Any> || !Any::called_for(scene)) && ...);
    }

    std::tuple<Effect...> effects_;
};

// The closed list of kernels, cheapest first; the first that covers a scene simulates it.

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

using KernelList = std::tuple<OpenCloth, RailsOnly, DragRails, DragRailsPockets>;

}  // namespace poolhall
