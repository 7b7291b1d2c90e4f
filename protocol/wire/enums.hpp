#pragma once

#include "protocol/messages.hpp"

#include <string_view>

// The enumerations that go over the wire by name. Each counts from 0 without a gap, so its last
// value says all.
namespace poolhall::protocol::wire {

/// "none", "end_game".
[[nodiscard]] std::string_view name(PocketModel model);
/// "elastic".
[[nodiscard]] std::string_view name(BallBallModel model);
/// "elastic", "restitution".
[[nodiscard]] std::string_view name(RailModel model);

template <class E>
inline constexpr E kLast = E{};
template <>
inline constexpr Stream kLast<Stream> = Stream::kShots;
template <>
inline constexpr RejectCode kLast<RejectCode> = RejectCode::kStorage;
template <>
inline constexpr Phase kLast<Phase> = Phase::kOver;
template <>
inline constexpr Verdict kLast<Verdict> = Verdict::kScratch;
template <>
inline constexpr EventKind kLast<EventKind> = EventKind::kBallPocket;
template <>
inline constexpr Outcome kLast<Outcome> = Outcome::kStalled;
template <>
inline constexpr Motion kLast<Motion> = Motion::kPocketed;
template <>
inline constexpr SolverKind kLast<SolverKind> = SolverKind::kOverlap;
template <>
inline constexpr Rail kLast<Rail> = Rail::kSouthWestJawW;
template <>
inline constexpr Pocket kLast<Pocket> = Pocket::kSouthWest;
template <>
inline constexpr PocketModel kLast<PocketModel> = PocketModel::kEndGame;
template <>
inline constexpr BallBallModel kLast<BallBallModel> = BallBallModel::kElastic;
template <>
inline constexpr RailModel kLast<RailModel> = RailModel::kRestitution;

}  // namespace poolhall::protocol::wire
