#pragma once

#include "protocol/wire/codecs.hpp"
#include "protocol/wire/listed_fields.hpp"
#include "protocol/wire/presets.hpp"
#include "shared/physics/effects/presets.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/table/presets.hpp"

#include <string>
#include <tuple>

// The fields of poolhall.scene/1. Ranges are left to check(), so that a scene is judged alike
// wherever it came from.
namespace poolhall::protocol::wire {

inline constexpr std::string_view kSceneSchema = "poolhall.scene/1";

/// The direction of a strike: two numbers, or three of which the last points down.
struct StrikeDirection {
    [[nodiscard]] bool read(const Cursor& cursor, Vec3& value) const;

    [[nodiscard]] Json write(const Vec3& value, Encoding encoding) const {
        return Vector2{}.write(xy(value), encoding);
    }
};

/// "none", "end_game", "pool", or a list of circles: Table::pockets and Table::circles.
struct PocketsCodec {
    [[nodiscard]] bool read(const Cursor& cursor, Table& table) const;
    [[nodiscard]] Json write(const Table& table, Encoding encoding) const;
};

/// A strike as it is written: by the ball's id.
struct StrikeForm {
    std::string ball;
    Vec3 direction;  ///< z < 0 is another way to give the elevation; never written
    Strike strike;   ///< the rest
};

/// A rail or an impact that is named has the defaults of its own, not those of what is not named;
/// but for a rail without a nose: in its place, what such a model does not use has always entered
/// the hash as it does where none is named.
template <>
struct DefaultCodec<RailSpec> : Fresh<RailSpec> {
    [[nodiscard]] bool read(const Cursor& cursor, RailSpec& value) const {
        if (!Fresh::read(cursor, value)) return false;
        if (has_nose(value.model)) return true;
        value = RailPart{}.rail;
        return read_fields(cursor, value);
    }
};

template <>
struct DefaultCodec<BallBallSpec> : Fresh<BallBallSpec> {};

/// In a file pockets and circles are one field.
template <>
inline constexpr auto kFields<Table> = std::tuple_cat(
    head_of<Table, 3>(),
    std::tuple{field(
                   "pockets", [](auto& table) -> auto& { return table; }, PocketsCodec{})
                   .or_default()},
    tail_of<Table, 5>());

template <>
struct DefaultCodec<Table> : WithPreset<Table, TablePreset> {};

template <>
struct DefaultCodec<BallSpec> : WithPreset<BallSpec, BallSet> {};

template <>
struct DefaultCodec<Effects> : WithPreset<Effects, EffectsPreset> {};

template <>
struct DefaultCodec<CueSpec> : WithPreset<CueSpec, CuePreset> {};

template <>
inline constexpr auto kFields<StrikeForm> =
    std::tuple_cat(std::tuple{field("ball", &StrikeForm::ball, Text{1, kMaxIdBytes}),
                              field("direction", &StrikeForm::direction, StrikeDirection{})},
                   within(&StrikeForm::strike, tail_of<Strike, 2>()));

/// All but "schema" and "strike", which SceneCodec adds.
template <>
inline constexpr auto kFields<Scene> = head_of<Scene, 8>();

/// A whole scene, check()ed.
struct SceneCodec {
    bool strike_required = false;

    [[nodiscard]] bool read(const Cursor& cursor, Scene& scene) const;
    [[nodiscard]] Json write(const Scene& scene, Encoding encoding) const;
};

}  // namespace poolhall::protocol::wire
