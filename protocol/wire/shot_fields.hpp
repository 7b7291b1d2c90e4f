#pragma once

#include "protocol/wire/codecs.hpp"
#include "protocol/wire/listed_fields.hpp"
#include "shared/analysis/effect_use.hpp"

#include <optional>
#include <tuple>
#include <vector>

// Events, states and rulings as they stand in messages: compact, balls by index.
namespace poolhall::protocol::wire {

/// A ShotEvent without its meaningless members.
struct EventForm {
    double t = 0;
    EventKind kind = EventKind::kStrike;
    std::vector<BallIndex> balls;
    std::optional<Rail> rail;
    std::optional<Pocket> pocket;
    std::vector<BallState> before;
    std::vector<BallState> after;
};

template <>
inline constexpr auto kFields<EventForm> = std::tuple{
    field("t", &EventForm::t, Number{0, kAnyMagnitude}),
    field("kind", &EventForm::kind),
    field("balls", &EventForm::balls, List<BallNumber>{{}, 2}),
    field("rail", &EventForm::rail),
    field("pocket", &EventForm::pocket),
    field("before", &EventForm::before, List<Object<BallState>>{{}, 2}),
    field("after", &EventForm::after, List<Object<BallState>>{{}, 2}),
};

struct EventCodec {
    [[nodiscard]] bool read(const Cursor& cursor, ShotEvent& event) const;
    [[nodiscard]] Json write(const ShotEvent& event, Encoding encoding) const;
};

/// A FinalBall without its meaningless member.
struct FinalBallForm {
    Motion motion = Motion::kStationary;
    std::optional<Pocket> pocket;
    BallState state;
};

template <>
inline constexpr auto kFields<FinalBallForm> = std::tuple_cat(
    std::tuple{field("motion", &FinalBallForm::motion), field("pocket", &FinalBallForm::pocket)},
    within(&FinalBallForm::state, kFields<BallState>));

struct FinalBallCodec {
    [[nodiscard]] bool read(const Cursor& cursor, FinalBall& ball) const;
    [[nodiscard]] Json write(const FinalBall& ball, Encoding encoding) const;
};

inline constexpr std::size_t kMaxEffectBytes = 64;  ///< of an effect's name
inline constexpr std::size_t kMaxEffectUses = 64;

template <>
inline constexpr auto kFields<analysis::EffectUse> = std::tuple{
    field("effect", &analysis::EffectUse::effect, Text{1, kMaxEffectBytes}),
    field("ruled_out", &analysis::EffectUse::ruled_out),
    field("acted", &analysis::EffectUse::acted),
};

inline constexpr List<Object<analysis::EffectUse>> kEffectUses{{}, kMaxEffectUses};

/// A ball of a Frame: [index, x, y], to 10 um in JSON and in single precision in CBOR.
struct FrameBallCodec {
    [[nodiscard]] bool read(const Cursor& cursor, Frame::Ball& ball) const;
    [[nodiscard]] Json write(const Frame::Ball& ball, Encoding encoding) const;
};

}  // namespace poolhall::protocol::wire
