#pragma once

#include "shared/enum_names.hpp"
#include "shared/fields.hpp"
#include "shared/math/vec3.hpp"
#include "shared/table/ball.hpp"
#include "shared/table/bounds.hpp"

#include <cstdint>
#include <optional>
#include <tuple>

namespace poolhall {

/// How far from the ball's middle a tip holds, in radii: farther out it slips off, a miscue. What
/// games allow. Alciatore: about 0.5, 0.6 at most (drdavepoolinfo.com, faq/cue/tip).
inline constexpr Real kMiscueOffset = 0.55;

/// What strikes the ball. Defaults: a plain cue of 19 oz with a leather tip.
struct CueSpec {
    Real mass = 0.5386;        ///< kg
    Real e = 0.73;             ///< restitution of tip and ball, 0 to 1
    Real tip_radius = 0.0106;  ///< of the tip's dome, m
    Real end_mass = 0.0085;    ///< that goes sideways with the ball, and deflects it (squirt); kg

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("mass", &CueSpec::mass, fields::positive(kMaxLength)).in("kg").or_default(),
            fields::of("e", &CueSpec::e, kShares).or_default(),
            fields::of("tip_radius", &CueSpec::tip_radius, {0, kMaxLength}).in("m").or_default(),
            fields::of("end_mass", &CueSpec::end_mass, {0, kMaxLength}).in("kg").or_default()};
    }

    friend constexpr bool operator==(const CueSpec&, const CueSpec&) = default;
};

/// Cues by name; shared/PHYSICS.md ("Presets") has the sources.
enum class CuePreset : std::uint8_t { kPlain, kLowDeflection, kBreak };

constexpr auto enum_names(CuePreset /*type*/) {
    return names_of<CuePreset>({{CuePreset::kPlain, "plain"},
                                {CuePreset::kLowDeflection, "low_deflection"},
                                {CuePreset::kBreak, "break"}});
}

[[nodiscard]] CueSpec preset_value(CuePreset preset);

/// The blow of the cue. A direction, never an angle: nothing has to be evaluated by a trigonometric
/// function, here or on another machine.
struct Strike {
    BallIndex ball;
    Vec2 direction{1, 0};  ///< of any length but zero
    Real speed = 0;        ///< of the ball right after it, or of `cue` right before; m/s
    /// Where the tip hits, seen along the cue: [side, vertical] in radii, shorter than 1. Side > 0
    /// is right english, vertical > 0 follow. With `cue`, where its axis points: the round tip
    /// touches nearer to the middle.
    Vec2 offset = {};
    Real elevation = 0;  ///< slope of the cue: how far it falls per metre of horizontal way
    /// Effective end mass of the cue over the ball's mass: what deflects the cue ball (squirt).
    /// Where it is not 0, instead of what `cue` says.
    Real end_mass_ratio = 0;
    std::optional<CueSpec> cue = {};  ///< present: speed and offset are the cue's; it has the mass

    static constexpr double kMaxSlope = 10;  ///< of the cue

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("ball", &Strike::ball),
            fields::of("direction", &Strike::direction),
            fields::of("speed", &Strike::speed, kSpeeds).in("m/s"),
            fields::of("offset", &Strike::offset).or_default(),
            fields::of("elevation", &Strike::elevation, {0, kMaxSlope}).or_default(),
            fields::of("end_mass_ratio", &Strike::end_mass_ratio, {0, 1}).or_default(),
            fields::of("cue", &Strike::cue).hashed_if_there()};
    }

    friend constexpr bool operator==(const Strike&, const Strike&) = default;
};

struct CueBallMotion {
    Vec3 v;  ///< m/s; z is not positive
    Vec3 w;  ///< rad/s
};

/// The strike as the ball feels it, told without a cue: where the tip touches, b = R/(R + tip
/// radius) of the offset, and the ball's speed after it, (1 + e) V / (1 + m/M + (5/2) b^2), m being
/// the ball's mass and M the cue's: restitution at the point of contact, which an offset makes
/// lighter (Kim, "Motions of a billiard ball after a cue stroke", New Phys.: Sae Mulli 72, 2022;
/// Alciatore, TP A.30, without loss).
[[nodiscard]] Strike strike_of_ball(const Strike& strike, const BallSpec& ball);

/// The motion of a ball of that radius (m) right after the strike, before the slate acts: a cue
/// that slopes down leaves v.z < 0, which becomes a bounce or nothing.
///
/// A strike without `cue`. The speed is the strike's. The spin is w = (5 / (2 R^2)) offset x v with
/// v along the cue (Alciatore, TP A.12): right english turns the ball counterclockwise seen from
/// above. The end of the cue deflects v from the cue's line, away from the english (squirt, TP
/// A.31).
[[nodiscard]] CueBallMotion strike_motion(const Strike& strike, Real radius);

/// The tangent of the angle of squirt, with the sign of `side` (radii, shorter than 1):
/// (5/2) b sqrt(1 - b^2) / (1 + 1/m + (5/2)(1 - b^2)), where m is the effective end mass of the cue
/// over the ball's mass; m = 0 gives none; pooltool takes 1/30. Alciatore, TP A.31.
[[nodiscard]] Real squirt_tangent(Real side, Real end_mass_ratio);

}  // namespace poolhall
