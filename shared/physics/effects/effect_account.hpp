#pragma once

#include "shared/physics/effects/all_effects.hpp"
#include "shared/physics/effects/prospect.hpp"
#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/effects/throw.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace poolhall {

namespace account_detail {

template <class Effects, class... More>
struct Appended;

template <class... Effect, class... More>
struct Appended<std::tuple<Effect...>, More...>
    : std::type_identity<std::tuple<Effect..., More...>> {};

}  // namespace account_detail

/// What an account of a shot can name: the effects, and models of impacts that are named with them.
using NamedEffects = account_detail::Appended<AllEffects, Throw>::type;

/// Of the effects that a scene names, which may act in a shot, and why the others cannot.
class EffectAccount {
  public:
    static constexpr std::size_t kEffectCount = std::tuple_size_v<NamedEffects>;

    /// Names nothing.
    EffectAccount() = default;

    EffectAccount(const SceneLike auto& scene, const Prospect& prospect) {
        judge(scene, prospect, std::type_identity<NamedEffects>{});
    }

    template <class Effect>
    [[nodiscard]] constexpr bool may_act() const {
        return (may_act_ & bit_of<Effect>()) != 0;
    }

    /// Whether every effect of the tuple that may act is one of the set.
    template <class Set, class... Effect>
    [[nodiscard]] constexpr bool is_covered(
        std::type_identity<std::tuple<Effect...>> /*effects*/) const {
        constexpr Bits kMissing = ((Set::template kHas<Effect> ? 0 : bit_of<Effect>()) | ...);
        return (may_act_ & kMissing) == 0;
    }

    /// Calls use(std::type_identity<Effect>, bound) for each effect that the scene names; `bound`
    /// is nothing where it may act.
    template <class Use>
    void for_each(Use use) const {
        visit(use, std::type_identity<NamedEffects>{});
    }

    friend constexpr bool operator==(const EffectAccount&, const EffectAccount&) = default;

  private:
    // A standing is one of these or the bound's value.
    static constexpr std::uint8_t kNotNamed = 255;
    static constexpr std::uint8_t kMayAct = 254;
    static_assert(kCount<Bound> < kMayAct);

    using Bits = std::uint32_t;
    static_assert(kEffectCount <= 32);

    /// Of its place among those that can be named.
    template <class Effect>
    static constexpr Bits bit_of() {
        return bit_of<Effect>(std::type_identity<NamedEffects>{});
    }

    template <class Wanted, class... Effect>
    static constexpr Bits bit_of(std::type_identity<std::tuple<Effect...>> /*all*/) {
        Bits bit = 0;
        Bits next = 1;
        ((bit |= std::is_same_v<Wanted, Effect> ? next : 0, next <<= 1U), ...);
        return bit;
    }

    template <class... Effect>
    void judge(const SceneLike auto& scene, const Prospect& prospect,
               std::type_identity<std::tuple<Effect...>> /*all*/) {
        std::size_t i = 0;
        ((standings_[i++] = standing_of<Effect>(scene, prospect)), ...);
        i = 0;
        ((may_act_ |= standings_[i++] == kMayAct ? bit_of<Effect>() : 0), ...);
    }

    template <class Effect>
    static std::uint8_t standing_of(const SceneLike auto& scene, const Prospect& prospect) {
        if (!Effect::called_for(scene)) return kNotNamed;
        std::optional<Bound> bound = Prospect::unless(prospect.moves, Bound::kNothingMoves);
        if constexpr (requires { Effect::ruled_out(scene, prospect); }) {
            if (!bound) bound = Effect::ruled_out(scene, prospect);
        }
        return bound ? static_cast<std::uint8_t>(*bound) : kMayAct;
    }

    template <class Use, class... Effect>
    void visit(Use& use, std::type_identity<std::tuple<Effect...>> /*all*/) const {
        std::size_t i = 0;
        (visit_one<Effect>(use, standings_[i++]), ...);
    }

    template <class Effect, class Use>
    static void visit_one(Use& use, std::uint8_t standing) {
        if (standing == kNotNamed) return;
        use(std::type_identity<Effect>{},
            standing == kMayAct ? std::nullopt : std::optional(static_cast<Bound>(standing)));
    }

    static constexpr std::array<std::uint8_t, kEffectCount> unnamed() {
        std::array<std::uint8_t, kEffectCount> all{};
        all.fill(kNotNamed);
        return all;
    }

    Bits may_act_ = 0;
    std::array<std::uint8_t, kEffectCount> standings_ = unnamed();
};

/// True if every effect of the scene that may act is in the set; the models of impacts need not be.
template <class Set>
[[nodiscard]] constexpr bool is_covered(const EffectAccount& account) {
    return account.is_covered<Set>(std::type_identity<AllEffects>{});
}

}  // namespace poolhall
