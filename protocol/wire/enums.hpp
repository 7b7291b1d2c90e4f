#pragma once

#include "protocol/messages.hpp"

#include <string_view>

// The enumerations that go over the wire by name. Each counts from 0 without a gap, so the last
// value that has a name says all.
namespace poolhall::protocol::wire {

/// "none", "end_game", "pool". kCircles is written as the list of its circles.
[[nodiscard]] std::string_view name(PocketModel model);
/// "elastic", "restitution", "friction".
[[nodiscard]] std::string_view name(BallBallModel model);
/// "elastic", "restitution", "han2005", "mathavan2010", "mathavan2010_fast".
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
inline constexpr Verdict kLast<Verdict> = Verdict::kTimedOut;
template <>
inline constexpr Accord kLast<Accord> = Accord::kRematch;
template <>
inline constexpr BreakOrder kLast<BreakOrder> = BreakOrder::kLoser;
template <>
inline constexpr Turns kLast<Turns> = Turns::kSolo;
template <>
inline constexpr EventKind kLast<EventKind> = EventKind::kOffTable;
template <>
inline constexpr Outcome kLast<Outcome> = Outcome::kStalled;
template <>
inline constexpr Motion kLast<Motion> = Motion::kOffTable;
template <>
inline constexpr SolverKind kLast<SolverKind> = SolverKind::kEvent;
template <>
inline constexpr Rail kLast<Rail> = Rail::kSouthWestJawW;
template <>
inline constexpr Pocket kLast<Pocket> = Pocket::kSouthWest;
template <>
inline constexpr PocketModel kLast<PocketModel> = PocketModel::kPool;
template <>
inline constexpr BallBallModel kLast<BallBallModel> = BallBallModel::kFriction;
template <>
inline constexpr RailModel kLast<RailModel> = RailModel::kMathavan2010Fast;

}  // namespace poolhall::protocol::wire
