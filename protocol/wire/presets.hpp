#pragma once

#include "protocol/wire/codecs.hpp"

#include <utility>

// Parts of a scene that have presets.
namespace poolhall::protocol::wire {

/// An object, or {"preset": NAME} with fields beside it, which are a merge patch (RFC 7396) of what
/// the preset gives: they override it, null takes away. Written without the preset.
template <HasFields T, NamedEnum Preset>
struct WithPreset {
    [[nodiscard]] bool read(const Cursor& cursor, T& value) const {
        if (!cursor.json().is_object()) return cursor.refuse("must be an object");
        const Json* name = cursor.find("preset");
        if (name == nullptr) {
            value = T{};
            return read_fields(cursor, value);
        }
        Preset preset{};
        if (!Named<Preset>{}.read(cursor.field("preset", *name), preset)) return false;
        Json merged = write(preset_value(preset), Encoding::kJson);
        merged.merge_patch(cursor.json());
        merged.erase("preset");
        value = T{};
        return read_fields(cursor.in_place(merged), value);
    }

    [[nodiscard]] Json write(const T& value, Encoding encoding) const {
        return Object<T>{}.write(value, encoding);
    }
};

}  // namespace poolhall::protocol::wire
