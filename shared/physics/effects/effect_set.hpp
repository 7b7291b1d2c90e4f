#pragma once

#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/motion/cloth_hooks.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace poolhall {

/// A set of effects chosen at compile time. An effect is a class that is made from a scene, says
/// `called_for(scene)`, and has some of the hooks of cloth_hooks.hpp and table_hooks.hpp; one that
/// is not in the set leaves no instruction behind.
template <class... Effect>
class EffectSet {
  public:
    explicit EffectSet(const SceneLike auto& scene) : effects_(Effect(scene)...) {}

    template <class Wanted>
    static constexpr bool kHas = (std::is_same_v<Wanted, Effect> || ...);

    template <class Wanted>
    [[nodiscard]] const Wanted& effect() const {
        return std::get<Wanted>(effects_);
    }

    /// Whether an effect of the set has the hook, as hooks::Slip.
    template <template <class> class Hook>
    static constexpr bool kHook = (Hook<Effect>::value || ...);

    /// The one effect that has it.
    template <template <class> class Hook>
    [[nodiscard]] const auto& hook() const {
        constexpr std::array<bool, sizeof...(Effect)> kHave{Hook<Effect>::value...};
        static_assert(std::count(kHave.begin(), kHave.end(), true) == 1);
        constexpr auto kPlace = std::find(kHave.begin(), kHave.end(), true) - kHave.begin();
        return std::get<static_cast<std::size_t>(kPlace)>(effects_);
    }

    /// Calls use(effect) for those effects that `use` accepts, in their order.
    template <class Use>
    void for_each([[maybe_unused]] Use use) const {
        (use_one<Effect>(use), ...);
    }

    /// True if every effect of `All` (a tuple) that the scene calls for is in the set.
    template <class All>
    [[nodiscard]] static bool covers(const SceneLike auto& scene) {
        return covers(scene, std::type_identity<All>{});
    }

    /// True if the scene calls for a force of the set.
    [[nodiscard]] static bool calls_for_force([[maybe_unused]] const SceneLike auto& scene) {
        return ((ForceEffect<Effect> && Effect::called_for(scene)) || ...);
    }

  private:
    template <class One, class Use>
    void use_one(Use& use) const {
        if constexpr (std::is_invocable_v<Use&, const One&>) use(std::get<One>(effects_));
    }

    template <class... Any>
    static bool covers(const SceneLike auto& scene, std::type_identity<std::tuple<Any...>>) {
        return ((kHas<Any> || !Any::called_for(scene)) && ...);
    }

    std::tuple<Effect...> effects_;
};

template <class Effects>
struct SetOfTuple;

template <class... Effect>
struct SetOfTuple<std::tuple<Effect...>> {
    using Type = EffectSet<Effect...>;
};

/// The set of the effects of a tuple.
template <class Effects>
using SetOf = typename SetOfTuple<Effects>::Type;

}  // namespace poolhall
