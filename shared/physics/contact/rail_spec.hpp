#pragma once

#include "shared/enum_names.hpp"
#include "shared/fields.hpp"
#include "shared/math/real.hpp"
#include "shared/table/bounds.hpp"

#include <cstdint>
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

/// How a ball meets a rail.
struct RailSpec {
    RailModel model = RailModel::kElastic;
    Real e = 1;     ///< coefficient of restitution, 0 to 1; not used by kElastic
    Real mu = 0.2;  ///< friction between ball and rail; used by Han's and Mathavan's models
    Real nose_height = 0.036576;  ///< of the rail's nose above the cloth, m; for the same

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("model", &RailSpec::model),
            fields::of("e", &RailSpec::e, kShares).or_default(),
            fields::of("mu", &RailSpec::mu, kFrictions).or_default(),
            fields::of("nose_height", &RailSpec::nose_height, fields::positive(kMaxLength))
                .in("m")
                .or_default()};
    }

    friend constexpr bool operator==(const RailSpec&, const RailSpec&) = default;
};

/// Its place among the effects of a scene.
struct RailPart {
    RailSpec rail;

    static constexpr auto part_field() { return fields::of("rail", &RailPart::rail).or_default(); }

    friend constexpr bool operator==(const RailPart&, const RailPart&) = default;
};

/// Whether the model knows where the nose is: a ball must reach above it.
[[nodiscard]] constexpr bool has_nose(RailModel model) {
    return model != RailModel::kElastic && model != RailModel::kRestitution;
}

}  // namespace poolhall
