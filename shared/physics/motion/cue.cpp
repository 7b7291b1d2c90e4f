#include "shared/physics/motion/cue.hpp"

#include <array>

namespace poolhall {

namespace {

/// The cue as the shooter sees it: right-angled unit vectors.
struct CueFrame {
    Vec3 forward;
    Vec3 right;  ///< horizontal
    Vec3 up;
};

CueFrame cue_frame(const Strike& strike) {
    const Vec2 way = normalized(strike.direction);
    const auto [cosine, sine] = normalized(Vec2{1, strike.elevation});
    return {.forward = {cosine * way.x, cosine * way.y, 0 - sine},
            .right = {way.y, -way.x, 0},
            .up = {sine * way.x, sine * way.y, cosine}};
}

/// The cue's direction turned by the squirt. Without squirt not a bit of it changes.
Vec3 departure(const CueFrame& cue, Real tangent) {
    if (tangent == 0) return cue.forward;
    return 1 / sqrt(1 + tangent * tangent) * (cue.forward - tangent * cue.right);
}

constexpr std::array<CueSpec, kCount<CuePreset>> kCues{{
    {0.5386, 0.73, 0.0106, 0.0085},
    {0.5386, 0.73, 0.0106, 0.0057},
    {0.5386, 0.84, 0.0106, 0.0142},
}};

}  // namespace

CueSpec preset_value(CuePreset preset) {
    return kCues[static_cast<std::size_t>(preset)];
}

Strike strike_of_ball(const Strike& strike, const BallSpec& ball) {
    if (!strike.cue) return strike;
    const CueSpec& cue = *strike.cue;
    Strike felt = strike;
    felt.cue.reset();
    if (felt.end_mass_ratio == 0) felt.end_mass_ratio = cue.end_mass / ball.mass;
    felt.offset = ball.radius / (ball.radius + cue.tip_radius) * strike.offset;
    felt.speed = (1 + cue.e) * strike.speed /
                 (1 + ball.mass / cue.mass + 2.5 * dot(felt.offset, felt.offset));
    return felt;
}

Real squirt_tangent(Real side, Real end_mass_ratio) {
    const Real depth = (1 - side) * (1 + side);  // 1 - b^2 without cancellation
    const Real push = 2.5 * end_mass_ratio * side * sqrt(depth);
    return push / (1 + end_mass_ratio * (1 + 2.5 * depth));
}

CueBallMotion strike_motion(const Strike& strike, Real radius) {
    const CueFrame cue = cue_frame(strike);
    const auto [side, vertical] = strike.offset;
    const Vec3 offset = side * cue.right + vertical * cue.up;
    const Real tangent = squirt_tangent(side, strike.end_mass_ratio);
    return {.v = strike.speed * departure(cue, tangent),
            .w = 2.5 * strike.speed / radius * cross(offset, cue.forward)};
}

}  // namespace poolhall
