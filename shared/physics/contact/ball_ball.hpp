#pragma once

#include "shared/enum_names.hpp"
#include "shared/fields.hpp"
#include "shared/math/vec2.hpp"
#include "shared/table/bounds.hpp"

#include <cstdint>
#include <optional>
#include <tuple>

namespace poolhall {

enum class BallBallModel : std::uint8_t {
    kElastic,       ///< e = 1, no friction
    kRestitution,   ///< e
    kFriction,      ///< e and friction: throw
    kMathavan2014,  ///< the same, and friction of the cloth meanwhile
};

constexpr auto enum_names(BallBallModel /*type*/) {
    return names_of<BallBallModel>({{BallBallModel::kElastic, "elastic"},
                                    {BallBallModel::kRestitution, "restitution"},
                                    {BallBallModel::kFriction, "friction"},
                                    {BallBallModel::kMathavan2014, "mathavan2014"}});
}

/// Friction between balls that falls with the speed of their slip: mu = a + b exp(-c u).
/// Defaults: Alciatore, TP A.14 (billiards.colostate.edu), fitted to Marlow's measurements.
struct FrictionBySpeed {
    Real a = 9.951e-3;
    Real b = 0.108;
    Real c = 1.088;  ///< s/m

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("a", &FrictionBySpeed::a, kFrictions).or_default(),
            fields::of("b", &FrictionBySpeed::b, kFrictions).or_default(),
            fields::of("c", &FrictionBySpeed::c, {0, kMaxSpeed}).in("s/m").or_default()};
    }

    friend constexpr bool operator==(const FrictionBySpeed&, const FrictionBySpeed&) = default;
};

/// How two balls meet. The impulse along the unit normal n from a to b makes them part at e times
/// the speed at which they approached; with equal masses and e = 1 they exchange the components
/// along n (text, 5.2.1). Friction between them is in ball_friction.hpp.
struct BallBallSpec {
    BallBallModel model = BallBallModel::kFriction;
    Real e = 0.95;   ///< coefficient of restitution, 0 to 1; not used by kElastic
    Real mu = 0.05;  ///< friction between balls; used by kFriction and kMathavan2014
    std::optional<FrictionBySpeed> friction_by_speed = {};  ///< instead of mu
    /// Balls that cloth friction can press together leave an impact at least this fast, m/s.
    Real min_separation = 1e-4;

    /// Parted by no more than this, pressed balls stay together to the eye, m/s.
    static constexpr double kMaxSeparation = 1;

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("model", &BallBallSpec::model).or_default(),
            fields::of("e", &BallBallSpec::e, kShares).or_default(),
            fields::of("mu", &BallBallSpec::mu, kFrictions).or_default(),
            fields::of("friction_by_speed", &BallBallSpec::friction_by_speed),
            fields::of("min_separation", &BallBallSpec::min_separation, {0, kMaxSeparation})
                .in("m/s")
                .or_default()};
    }

    friend constexpr bool operator==(const BallBallSpec&, const BallBallSpec&) = default;
};

/// Its place among the effects of a scene.
struct BallBallPart {
    BallBallSpec ball_ball{BallBallModel::kElastic};  ///< of a scene that names none

    static constexpr auto part_field() {
        return fields::of("ball_ball", &BallBallPart::ball_ball).or_default();
    }

    friend constexpr bool operator==(const BallBallPart&, const BallBallPart&) = default;
};

/// The coefficient of restitution.
[[nodiscard]] constexpr Real restitution_of(const BallBallSpec& spec) {
    return spec.model == BallBallModel::kElastic ? 1 : spec.e;
}

[[nodiscard]] constexpr bool has_friction(const BallBallSpec& spec) {
    const bool rubs =
        spec.model == BallBallModel::kFriction || spec.model == BallBallModel::kMathavan2014;
    return rubs && (spec.friction_by_speed || spec.mu > 0);
}

/// The velocities after the elastic impact of two equal balls, at the unit normal n from a to b.
inline void exchange_normal_velocity(Vec2& v_a, Vec2& v_b, Vec2 n) {
    const Vec2 impulse = dot(v_a - v_b, n) * n;
    v_a = v_a - impulse;
    v_b = v_b + impulse;
}

}  // namespace poolhall
