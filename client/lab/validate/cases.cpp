#include "client/lab/validate/cases.hpp"

#include "shared/physics/simulate.hpp"

#include <cmath>

namespace poolhall::lab {

namespace {

/// So near that nothing happens to a ball on the way, m.
constexpr double kHardlyAny = 1e-9;

Vec3 turned(double length, double angle) {
    return {length * std::cos(angle), length * std::sin(angle), 0};
}

/// The spin of a ball that rolls with v.
Vec3 rolling_spin(Vec3 v, double radius) {
    return {-v.y / radius, v.x / radius, 0};
}

Scene on_cloth(const BallSpec& ball, double mu_slide) {
    Scene scene;
    scene.table.rails = false;
    scene.ball = ball;
    scene.effects.sliding = SlidingSpec{mu_slide};
    scene.solver.kind = SolverKind::kEvent;
    return scene;
}

/// Cue ball and object ball just before the impact, the line of centres along x.
Scene scene_of(const TwoBallCase& one) {
    Scene scene = on_cloth(one.ball, SlidingSpec{}.mu);
    scene.effects.ball_ball = one.impact;
    const Vec3 v = turned(one.speed, one.cut);
    Vec3 w = rolling_spin(v, one.ball.radius);
    w = {one.follow * w.x, one.follow * w.y, one.english * one.speed / one.ball.radius};
    scene.balls = {{"cue", {{-2 * one.ball.radius - kHardlyAny, 0, 0}, v, w}},
                   {"object", {{0, 0, 0}, {}, {}}}};
    return scene;
}

Scene scene_of(const RailCase& one) {
    Scene scene = on_cloth(one.ball, one.mu_slide);
    scene.table.rails = true;
    scene.effects.rail = one.rail;
    const Vec3 v = turned(one.speed, one.incidence);
    const double edge = inset(scene.table, one.ball.radius).x;
    scene.balls = {{"cue", {{edge - kHardlyAny, 0, 0}, v, rolling_spin(v, one.ball.radius)}}};
    return scene;
}

/// The place of the first event of that kind.
std::size_t place_of(const ShotTrace& trace, EventKind kind) {
    std::size_t i = 0;
    while (trace.events.at(i).kind != kind)
        ++i;
    return i;
}

Vec2 just_after(const ShotTrace& trace, EventKind impact, std::uint8_t ball) {
    const ShotEvent& event = trace.events.at(place_of(trace, impact));
    return xy(event.after[event.balls[0].value == ball ? 0 : 1].v);
}

/// The ball's velocity when the slip that the impact left has ended.
Vec2 after_slip(const ShotTrace& trace, EventKind impact, std::uint8_t ball) {
    for (std::size_t i = place_of(trace, impact) + 1; i < trace.events.size(); ++i) {
        const ShotEvent& event = trace.events[i];
        if (event.kind == EventKind::kSlideToRoll && event.balls[0].value == ball)
            return xy(event.after[0].v);
    }
    return just_after(trace, impact, ball);
}

TwoBallOutcome outcome_of(const TwoBallCase& one, Vec2 cue, Vec2 object) {
    const auto angle = [&](Vec2 v) { return std::atan2(v.y, v.x) - one.cut; };
    return {norm(cue), angle(cue), norm(object), angle(object)};
}

/// Of a trace with a rail's impact: the velocity, mirrored to go into the rail.
RailOutcome outcome_of(Vec2 v) {
    return {norm(v), std::atan2(v.y, -v.x)};
}

}  // namespace

TwoBallOutcome just_after(const TwoBallCase& one) {
    const ShotTrace trace = simulate(scene_of(one));
    return outcome_of(one, just_after(trace, EventKind::kBallBall, 0),
                      just_after(trace, EventKind::kBallBall, 1));
}

TwoBallOutcome after_slip(const TwoBallCase& one) {
    const ShotTrace trace = simulate(scene_of(one));
    return outcome_of(one, after_slip(trace, EventKind::kBallBall, 0),
                      after_slip(trace, EventKind::kBallBall, 1));
}

TwoBallCase with_object_angle(TwoBallCase one, double object_angle) {
    constexpr int kRounds = 30;
    one.cut = -object_angle;
    for (int i = 0; i < kRounds; ++i)
        one.cut += just_after(one).object_angle - object_angle;
    return one;
}

double throw_of(const TwoBallCase& one) {
    return std::abs(just_after(one).object_angle + one.cut);
}

RailOutcome just_after(const RailCase& one) {
    return outcome_of(just_after(simulate(scene_of(one)), EventKind::kBallRail, 0));
}

RailOutcome after_slip(const RailCase& one) {
    Scene scene = scene_of(one);
    // Nothing else is to be met before the slip has ended.
    scene.table.length = 100;
    scene.table.width = 100;
    scene.balls[0].state.r.x = inset(scene.table, one.ball.radius).x - kHardlyAny;
    return outcome_of(after_slip(simulate(scene), EventKind::kBallRail, 0));
}

}  // namespace poolhall::lab
