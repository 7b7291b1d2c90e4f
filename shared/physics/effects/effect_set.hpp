#pragma once

#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/scene/scene.hpp"

#include <tuple>
#include <type_traits>

namespace poolhall {

/// A force on a ball that moves: push(ball, dt) changes its velocity and spin for a step of dt s,
/// after cloth and drag. It has no closed form, so only the stepping solvers take it.
template <class Effect>
concept ForceEffect = requires(const Effect& effect, MovingBall& ball) {
    effect.push(ball, 0.0);
};

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

    /// Calls use(effect) for those effects that `use` accepts, in their order.
    template <class Use>
    void for_each([[maybe_unused]] Use use) const {
        (use_one<Effect>(use), ...);
    }

    /// True if every effect of `All` (a tuple) that the scene calls for is in the set.
    template <class All>
    [[nodiscard]] static bool covers(const Scene& scene) {
        return covers(scene, std::type_identity<All>{});
    }

    /// True if the scene calls for a force of the set.
    [[nodiscard]] static bool calls_for_force([[maybe_unused]] const Scene& scene) {
        return ((ForceEffect<Effect> && Effect::called_for(scene)) || ...);
    }

  private:
    template <class One, class Use>
    void use_one(Use& use) const {
        if constexpr (std::is_invocable_v<Use&, const One&>) use(std::get<One>(effects_));
    }

    template <class... Any>
    static bool covers(const Scene& scene, std::type_identity<std::tuple<Any...>>) {
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

/// An effect that takes balls that come to a place: first_capture(r, v, time) and at(r).
template <class Effect>
concept PocketEffect = requires(const Effect& effect, Vec2 r) {
    effect.first_capture(r, r, 0.0);
    effect.at(r);
};

}  // namespace poolhall
