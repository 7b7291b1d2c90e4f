#pragma once

#include "protocol/limits.hpp"
#include "protocol/messages.hpp"
#include "protocol/wire/fields.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

// The codecs that messages and scenes are put together from.
namespace poolhall::protocol::wire {

inline constexpr double kAnyMagnitude = std::numeric_limits<double>::max();

/// A finite number.
struct Number {
    double min = -kAnyMagnitude;
    double max = kAnyMagnitude;

    [[nodiscard]] bool read(const Cursor& cursor, double& value) const;

    [[nodiscard]] Json write(double value, Encoding /*encoding*/) const { return value; }
};

/// A number of a scene: a JSON number or, in files, a string with a C hex-float.
struct SceneNumber {
    [[nodiscard]] bool read(const Cursor& cursor, double& value) const;

    [[nodiscard]] Json write(double value, Encoding /*encoding*/) const { return value; }
};

struct Integer {
    std::uint32_t min = 0;
    std::uint32_t max = std::numeric_limits<std::uint32_t>::max();

    template <std::integral T>
    [[nodiscard]] bool read(const Cursor& cursor, T& value) const {
        std::uint32_t number = 0;
        if (!read_number(cursor, number)) return false;
        value = static_cast<T>(number);
        return true;
    }

    template <std::integral T>
    [[nodiscard]] Json write(T value, Encoding /*encoding*/) const {
        return value;
    }

  private:
    [[nodiscard]] bool read_number(const Cursor& cursor, std::uint32_t& value) const;
};

struct Boolean {
    [[nodiscard]] bool read(const Cursor& cursor, bool& value) const;

    [[nodiscard]] Json write(bool value, Encoding /*encoding*/) const { return value; }
};

/// 0 or 1.
struct SeatNumber {
    [[nodiscard]] bool read(const Cursor& cursor, Seat& value) const {
        return Integer{0, kSeatCount - 1}.read(cursor, value.value);
    }

    [[nodiscard]] Json write(Seat value, Encoding /*encoding*/) const { return value.value; }
};

struct BallNumber {
    [[nodiscard]] bool read(const Cursor& cursor, BallIndex& value) const {
        return Integer{0, kMaxBalls - 1}.read(cursor, value.value);
    }

    [[nodiscard]] Json write(BallIndex value, Encoding /*encoding*/) const { return value.value; }
};

/// A hash as 16 lower-case hex digits: a double cannot hold it.
struct Hash {
    [[nodiscard]] bool read(const Cursor& cursor, std::uint64_t& value) const;
    [[nodiscard]] Json write(std::uint64_t value, Encoding encoding) const;
};

struct Text {
    std::size_t min_bytes = 0;
    std::size_t max_bytes = 0;

    [[nodiscard]] bool read(const Cursor& cursor, std::string& value) const;

    [[nodiscard]] Json write(const std::string& value, Encoding /*encoding*/) const {
        return value;
    }
};

/// What a player or spectator is called. Where a name enters, Reading::enter_name says what it may
/// be and becomes; what a server has taken, today's or an older one, is only checked for what could
/// harm a display.
struct PersonName {
    bool may_be_empty = false;

    [[nodiscard]] bool read(const Cursor& cursor, std::string& value) const;

    [[nodiscard]] Json write(const std::string& value, Encoding /*encoding*/) const {
        return value;
    }
};

/// A join code; read as people type it, kept in one form.
struct JoinCode {
    [[nodiscard]] bool read(const Cursor& cursor, std::string& value) const;

    [[nodiscard]] Json write(const std::string& value, Encoding /*encoding*/) const {
        return value;
    }
};

struct Token {
    bool may_be_empty = false;

    [[nodiscard]] bool read(const Cursor& cursor, std::string& value) const;

    [[nodiscard]] Json write(const std::string& value, Encoding /*encoding*/) const {
        return value;
    }
};

/// [x, y], each at most `limit` in magnitude.
struct Vector2 {
    double limit = kMaxPositionComponent;

    [[nodiscard]] bool read(const Cursor& cursor, Vec2& value) const;

    [[nodiscard]] Json write(Vec2 value, Encoding /*encoding*/) const {
        return Json::array({value.x, value.y});
    }
};

/// A direction of aim: any length but zero.
struct Direction {
    [[nodiscard]] bool read(const Cursor& cursor, Vec2& value) const;

    [[nodiscard]] Json write(Vec2 value, Encoding encoding) const {
        return Vector2{}.write(value, encoding);
    }
};

/// [x, y, z] of a state, of which the first `min_count` must be there.
struct Vector3 {
    std::size_t min_count = 3;

    [[nodiscard]] bool read(const Cursor& cursor, Vec3& value) const;

    [[nodiscard]] Json write(const Vec3& value, Encoding /*encoding*/) const {
        return Json::array({value.x, value.y, value.z});
    }
};

/// Two numbers of a scene.
struct SceneVector2 {
    [[nodiscard]] bool read(const Cursor& cursor, Vec2& value) const;

    [[nodiscard]] Json write(Vec2 value, Encoding encoding) const {
        return Vector2{}.write(value, encoding);
    }
};

/// Checks for an array of min to max elements.
[[nodiscard]] bool expect_array(const Cursor& cursor, std::size_t min, std::size_t max);
/// Checks for a string.
[[nodiscard]] bool expect_text(const Cursor& cursor);

/// The name of an enumerator, but for those without one.
template <NamedEnum E>
struct Named {
    [[nodiscard]] bool read(const Cursor& cursor, E& value) const {
        if (!expect_text(cursor)) return false;
        const auto found = find<E>(cursor.json().template get_ref<const std::string&>());
        if (!found) return cursor.refuse("must be one of " + choices());
        value = *found;
        return true;
    }

    [[nodiscard]] Json write(E value, Encoding /*encoding*/) const { return poolhall::name(value); }

  private:
    static std::string choices() {
        std::string all;
        for (const E value : kValues<E>) {
            const std::string_view one = poolhall::name(value);
            if (!one.empty()) all.append(all.empty() ? "" : ", ").append(one);
        }
        return all;
    }
};

/// An object with kFields.
template <HasFields T>
struct Object {
    [[nodiscard]] bool read(const Cursor& cursor, T& value) const {
        return read_fields(cursor, value);
    }

    [[nodiscard]] Json write(const T& value, Encoding encoding) const {
        Json object = Json::object();
        write_fields(object, value, encoding);
        return object;
    }
};

/// An object whose fields that are left out are those of a new T.
template <HasFields T>
struct Fresh : Object<T> {
    [[nodiscard]] bool read(const Cursor& cursor, T& value) const {
        value = T{};
        return read_fields(cursor, value);
    }
};

/// An array of any length up to a limit.
template <class ElementCodec>
struct List {
    ElementCodec codec;
    std::size_t max_count = 0;

    template <class T>
    [[nodiscard]] bool read(const Cursor& cursor, std::vector<T>& values) const {
        if (!expect_array(cursor, 0, max_count)) return false;
        values.resize(cursor.json().size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!codec.read(cursor.element(i), values[i])) return false;
        }
        return true;
    }

    template <class T>
    [[nodiscard]] Json write(const std::vector<T>& values, Encoding encoding) const {
        Json array = Json::array();
        for (const T& value : values)
            array.push_back(codec.write(value, encoding));
        return array;
    }
};

/// An array of a fixed number of elements.
template <class ElementCodec>
struct Array {
    ElementCodec codec;

    template <class T, std::size_t kSize>
    [[nodiscard]] bool read(const Cursor& cursor, std::array<T, kSize>& values) const {
        if (!expect_array(cursor, kSize, kSize)) return false;
        for (std::size_t i = 0; i < kSize; ++i) {
            if (!codec.read(cursor.element(i), values[i])) return false;
        }
        return true;
    }

    template <class T, std::size_t kSize>
    [[nodiscard]] Json write(const std::array<T, kSize>& values, Encoding encoding) const {
        Json array = Json::array();
        for (const T& value : values)
            array.push_back(codec.write(value, encoding));
        return array;
    }
};

template <>
struct DefaultCodec<bool> : Boolean {};

template <>
struct DefaultCodec<double> : Number {};

template <>
struct DefaultCodec<std::uint32_t> : Integer {};

template <>
struct DefaultCodec<Seat> : SeatNumber {};

template <>
struct DefaultCodec<BallIndex> : BallNumber {};

template <NamedEnum E>
struct DefaultCodec<E> : Named<E> {};

template <HasFields T>
struct DefaultCodec<T> : Object<T> {};

template <class T>
struct DefaultCodec<std::optional<T>> : DefaultCodec<T> {};

}  // namespace poolhall::protocol::wire
