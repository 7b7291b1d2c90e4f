#pragma once

#include "protocol/replay/record.hpp"
#include "protocol/wire/game_fields.hpp"
#include "protocol/wire/scene_fields.hpp"
#include "protocol/wire/settings_fields.hpp"
#include "protocol/wire/shot_fields.hpp"

#include <cmath>
#include <concepts>
#include <tuple>

// The fields of the records, in the order in which they are written.
namespace poolhall::protocol::wire {

/// A whole number that a double can hold, so that every JSON library reads it exactly.
struct Count {
    std::uint64_t min = 0;

    template <std::integral T>
    bool read(const Cursor& cursor, T& value) const {
        constexpr std::uint64_t kMax = std::uint64_t{1} << 53U;
        const Json& json = cursor.json();
        if (!json.is_number_unsigned() || json.get<std::uint64_t>() < min ||
            json.get<std::uint64_t>() > kMax) {
            return cursor.refuse("must be a whole number from " + std::to_string(min) + " to 2^53");
        }
        value = json.get<T>();
        return true;
    }

    template <std::integral T>
    [[nodiscard]] Json write(T value, Encoding /*encoding*/) const {
        return value;
    }
};

struct MatchId {
    bool read(const Cursor& cursor, std::string& value) const;

    [[nodiscard]] Json write(const std::string& value, Encoding /*encoding*/) const {
        return value;
    }
};

inline constexpr Text kShortText{1, 64};
inline constexpr Text kReasonText{0, 256};
/// Not PersonName: what counts as a name may change, and a log keeps those that were taken.
inline constexpr Text kNameText{0, kMaxNameBytes};
inline constexpr Number kSeconds{0, kAnyMagnitude};

template <>
inline constexpr auto kFields<MatchRecord> = std::tuple{
    field("match", &MatchRecord::match, MatchId{}),
    field("game", &MatchRecord::game, kShortText),
    field("server", &MatchRecord::server, kShortText),
    field("created_ms", &MatchRecord::created_ms, Count{}),
    field("settings", &MatchRecord::settings),
    field("first", &MatchRecord::first),
};

template <>
inline constexpr auto kFields<SeatRecord> = std::tuple{
    field("seat", &SeatRecord::seat),
    field("name", &SeatRecord::name, kNameText),
};

template <>
inline constexpr auto kFields<ShotEvidence> = std::tuple{
    field("shot", &ShotEvidence::shot, Integer{1}),
    field("edition", &ShotEvidence::edition),
    field("solver", &ShotEvidence::solver, kShortText),
    field("kernel", &ShotEvidence::kernel, kShortText),
    field("effects", &ShotEvidence::effects, kEffectUses),
    field("trace", &ShotEvidence::trace, Hash{}),
    field("duration", &ShotEvidence::duration, kSeconds),
    field("event_count", &ShotEvidence::event_count),
    field("event_times", &ShotEvidence::event_times, List<Number>{kSeconds, kMaxEventTimes}),
};

template <>
inline constexpr auto kFields<MoveRecord> = std::tuple{
    field("seat", &MoveRecord::seat),
    field("move", &MoveRecord::move, Tagged{}),
    field("state", &MoveRecord::state, GameStateCodec{}),
    field("state_hash", &MoveRecord::state_hash, Hash{}),
    field("ruling", &MoveRecord::ruling),
    field("shot", &MoveRecord::shot),
    field("at_ms", &MoveRecord::at_ms, Count{}),
};

template <>
inline constexpr auto kFields<GameRecord> = std::tuple{
    field("game_number", &GameRecord::game_number, Integer{1}),
    field("first", &GameRecord::first),
};

template <>
inline constexpr auto kFields<ShotRecord> = std::tuple{
    field("shot", &ShotRecord::shot, Integer{1}),
    field("game_number", &ShotRecord::game_number, Integer{1}),
    field("seat", &ShotRecord::seat),
    field("scene", &ShotRecord::scene, SceneCodec{true}),
    field("scene_hash", &ShotRecord::scene_hash, Hash{}),
    field("kernel", &ShotRecord::kernel, kShortText),
    field("final_hash", &ShotRecord::final_hash, Hash{}),
    field("duration", &ShotRecord::duration, kSeconds),
    field("event_count", &ShotRecord::event_count),
    field("event_times", &ShotRecord::event_times, List<Number>{kSeconds, kMaxEventTimes}),
    field("ruling", &ShotRecord::ruling),
    field("at_ms", &ShotRecord::at_ms, Count{}),
};

template <>
inline constexpr auto kFields<EndRecord> = std::tuple{
    field("reason", &EndRecord::reason, kReasonText),
    field("at_ms", &EndRecord::at_ms, Count{}),
};

}  // namespace poolhall::protocol::wire
