#include "protocol/wire/shot_fields.hpp"

#include <algorithm>
#include <cmath>

namespace poolhall::protocol::wire {
namespace {

constexpr double kFrameSteps = 1e5;  ///< JSON positions are shown in steps of 10 um; 1/m

EventForm form_of(const ShotEvent& event) {
    const auto count = event.ball_count;
    EventForm form{event.t,
                   event.kind,
                   {event.balls.begin(), event.balls.begin() + count},
                   std::nullopt,
                   std::nullopt,
                   {event.before.begin(), event.before.begin() + count},
                   {event.after.begin(), event.after.begin() + count}};
    if (event.kind == EventKind::kBallRail) form.rail = event.rail;
    if (event.kind == EventKind::kBallPocket) form.pocket = event.pocket;
    return form;
}

/// The arrays agree, and the kind has what it needs and nothing else.
bool check_form(const Cursor& cursor, const EventForm& form) {
    const std::size_t count = form.kind == EventKind::kBallBall ? 2 : 1;
    if (form.balls.size() != count)
        return cursor.refuse_at("/balls", "must have one index for each ball of its kind");
    if (form.before.size() != count)
        return cursor.refuse_at("/before", "must have one state for each ball");
    if (form.after.size() != count)
        return cursor.refuse_at("/after", "must have one state for each ball");
    if (form.rail.has_value() != (form.kind == EventKind::kBallRail)) {
        return cursor.refuse_at("/rail", "must be there for ball_rail and for nothing else");
    }
    if (form.pocket.has_value() != (form.kind == EventKind::kBallPocket)) {
        return cursor.refuse_at("/pocket", "must be there for ball_pocket and for nothing else");
    }
    return true;
}

}  // namespace

bool EventCodec::read(const Cursor& cursor, ShotEvent& event) const {
    EventForm form;
    if (!read_fields(cursor, form) || !check_form(cursor, form)) return false;
    event.t = form.t;
    event.kind = form.kind;
    event.ball_count = static_cast<std::uint8_t>(form.balls.size());
    event.rail = form.rail.value_or(event.rail);
    event.pocket = form.pocket.value_or(event.pocket);
    std::copy(form.balls.begin(), form.balls.end(), event.balls.begin());
    std::copy(form.before.begin(), form.before.end(), event.before.begin());
    std::copy(form.after.begin(), form.after.end(), event.after.begin());
    return true;
}

Json EventCodec::write(const ShotEvent& event, Encoding encoding) const {
    return Object<EventForm>{}.write(form_of(event), encoding);
}

bool FinalBallCodec::read(const Cursor& cursor, FinalBall& ball) const {
    FinalBallForm form;
    if (!read_fields(cursor, form)) return false;
    if (form.pocket.has_value() != (form.motion == Motion::kPocketed)) {
        return cursor.refuse_at("/pocket", "must be there for a pocketed ball and for no other");
    }
    ball = {form.motion, form.pocket.value_or(ball.pocket), form.state};
    return true;
}

Json FinalBallCodec::write(const FinalBall& ball, Encoding encoding) const {
    FinalBallForm form{ball.motion, std::nullopt, ball.state};
    if (ball.motion == Motion::kPocketed) form.pocket = ball.pocket;
    return Object<FinalBallForm>{}.write(form, encoding);
}

bool FrameBallCodec::read(const Cursor& cursor, Frame::Ball& ball) const {
    if (!expect_array(cursor, 3, 3)) return false;
    const Number coordinate{-kMaxPositionComponent, kMaxPositionComponent};
    return BallNumber{}.read(cursor.element(0), ball.ball) &&
           coordinate.read(cursor.element(1), ball.r.x) &&
           coordinate.read(cursor.element(2), ball.r.y);
}

Json FrameBallCodec::write(const Frame::Ball& ball, Encoding encoding) const {
    const auto shortened = [encoding](double x) {
        // A float goes out in 5 bytes of CBOR: the writer takes the shortest form that keeps the
        // value.
        if (encoding == Encoding::kCbor) return static_cast<double>(static_cast<float>(x));
        return std::round(x * kFrameSteps) / kFrameSteps;
    };
    return Json::array({ball.ball.value, shortened(ball.r.x), shortened(ball.r.y)});
}

}  // namespace poolhall::protocol::wire
