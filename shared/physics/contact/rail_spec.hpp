#pragma once

#include "shared/enum_names.hpp"
#include "shared/fields.hpp"
#include "shared/math/real.hpp"
#include "shared/table/bounds.hpp"

#include <cstdint>
#include <optional>
#include <tuple>

namespace poolhall {

enum class RailModel : std::uint8_t {
    kElastic,
    kRestitution,
    kHan2005,
    kMathavan2010,
    kMathavan2010Fast,  ///< fewer steps, for many shots
};

constexpr auto enum_names(RailModel /*type*/) {
    return names_of<RailModel>({{RailModel::kElastic, "elastic"},
                                {RailModel::kRestitution, "restitution"},
                                {RailModel::kHan2005, "han2005"},
                                {RailModel::kMathavan2010, "mathavan2010"},
                                {RailModel::kMathavan2010Fast, "mathavan2010_fast"}});
}

/// Restitution of a nose that is soft for a fast ball and sticks to a slow one: of what approaches
/// at v along the normal, e(v) = e / (1 + s (v/b + b/v - 2)), at its largest, e, where v = b. It is
/// positive and below 1 at any speed, and with s <= 1/2 what comes in faster leaves faster.
/// Defaults: fitted to the rebounds of Mathavan, Jackson, Parkin, Am. J. Phys. 77(9), 2009, by
/// Mathavan's rail with mu 0.14 (PHYSICS.md).
struct RestitutionBySpeed {
    Real e = 1;
    Real best_speed = 1.19;   ///< b, m/s
    Real softening = 0.1285;  ///< s

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("e", &RestitutionBySpeed::e, kShares).or_default(),
            fields::of("best_speed", &RestitutionBySpeed::best_speed, fields::positive(kMaxSpeed))
                .in("m/s")
                .or_default(),
            fields::of("softening", &RestitutionBySpeed::softening, {0, 0.5}).or_default()};
    }

    friend constexpr bool operator==(const RestitutionBySpeed&,
                                     const RestitutionBySpeed&) = default;
};

/// How a ball meets a rail.
struct RailSpec {
    RailModel model = RailModel::kMathavan2010;
    Real e = 0.98;   ///< coefficient of restitution, 0 to 1; not used by kElastic
    Real mu = 0.14;  ///< friction between ball and rail; used by Han's and Mathavan's models
    Real nose_height = 0.03629025;  ///< of the rail's nose above the cloth, m; for the same
    std::optional<RestitutionBySpeed> e_by_speed = {};  ///< instead of e; for the same

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("model", &RailSpec::model).or_default(),
            fields::of("e", &RailSpec::e, kShares).or_default(),
            fields::of("mu", &RailSpec::mu, kFrictions).or_default(),
            fields::of("nose_height", &RailSpec::nose_height, fields::positive(kMaxLength))
                .in("m")
                .or_default(),
            fields::of("e_by_speed", &RailSpec::e_by_speed).hashed_if_there()};
    }

    friend constexpr bool operator==(const RailSpec&, const RailSpec&) = default;
};

/// Its place among the effects of a scene.
struct RailPart {
    /// Of a scene that names none. The rest means nothing but enters the scene's hash.
    RailSpec rail{RailModel::kElastic, 1, 0.2, 0.036576};

    static constexpr auto part_field() { return fields::of("rail", &RailPart::rail).or_default(); }

    friend constexpr bool operator==(const RailPart&, const RailPart&) = default;
};

/// Whether the model knows where the nose is: a ball must reach above it.
[[nodiscard]] constexpr bool has_nose(RailModel model) {
    return model != RailModel::kElastic && model != RailModel::kRestitution;
}

/// Of a rail with a nose, for a ball that approaches it at that speed along the normal, m/s.
[[nodiscard]] constexpr Real restitution_of(const RailSpec& spec, Real approach) {
    if (!spec.e_by_speed) return spec.e;
    const auto& [e, best, softening] = *spec.e_by_speed;
    return e / (1 + softening * (approach / best + best / approach - 2));
}

}  // namespace poolhall
