#include "protocol/wire/codecs.hpp"

#include "protocol/text.hpp"
#include "shared/physics/scene/trace.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace poolhall::protocol::wire {
namespace {

const std::string& text_of(const Cursor& cursor) {
    return cursor.json().get_ref<const std::string&>();
}

/// Whether the double is the integer, not one near it.
bool is_exact(const Json& integer, double value) {
    constexpr double kTwoTo63 = 9223372036854775808.0;
    if (integer.is_number_unsigned())
        return value < 2 * kTwoTo63 &&
               static_cast<std::uint64_t>(value) == integer.get<std::uint64_t>();
    return static_cast<std::int64_t>(value) == integer.get<std::int64_t>();
}

bool read_finite(const Cursor& cursor, double& value) {
    const Json& json = cursor.json();
    if (json.is_discarded()) return cursor.refuse("must be a number that a double can hold");
    if (!json.is_number()) return cursor.refuse("must be a number");
    value = json.get<double>();
    if (json.is_number_integer() && !is_exact(json, value))
        return cursor.refuse("must be a number that a double can hold");
    return std::isfinite(value) || cursor.refuse("must be finite");
}

}  // namespace

bool expect_array(const Cursor& cursor, std::size_t min, std::size_t max) {
    if (!cursor.json().is_array()) return cursor.refuse("must be an array");
    const std::size_t count = cursor.json().size();
    if (count >= min && count <= max) return true;
    const std::string range =
        min == max ? std::to_string(min) : std::to_string(min) + " to " + std::to_string(max);
    return cursor.refuse("must have " + range + " elements");
}

bool expect_text(const Cursor& cursor) {
    return cursor.json().is_string() || cursor.refuse("must be a string");
}

bool Number::read(const Cursor& cursor, double& value) const {
    if (!read_finite(cursor, value)) return false;
    if (value >= min && value <= max) return true;
    return cursor.refuse("must be from " + Json(min).dump() + " to " + Json(max).dump());
}

bool SceneNumber::read(const Cursor& cursor, double& value) const {
    if (!cursor.json().is_string() || !cursor.reads_hex_floats()) return read_finite(cursor, value);
    const auto number = parse_hex_float(text_of(cursor));
    if (!number) return cursor.refuse("must be a number or a finite C hex-float string");
    value = *number;
    return true;
}

bool Integer::read_number(const Cursor& cursor, std::uint32_t& value) const {
    const Json& json = cursor.json();
    if (!json.is_number_integer()) return cursor.refuse("must be an integer");
    // What is stored as signed is negative, or the -0 of JSON.
    const bool negative = !json.is_number_unsigned() && json.get<std::int64_t>() < 0;
    const bool fits =
        !negative && json.get<std::uint64_t>() >= min && json.get<std::uint64_t>() <= max;
    if (!fits)
        return cursor.refuse("must be from " + std::to_string(min) + " to " + std::to_string(max));
    value = json.get<std::uint32_t>();
    return true;
}

bool Boolean::read(const Cursor& cursor, bool& value) const {
    if (!cursor.json().is_boolean()) return cursor.refuse("must be true or false");
    value = cursor.json().get<bool>();
    return true;
}

bool Hash::read(const Cursor& cursor, std::uint64_t& value) const {
    if (!expect_text(cursor)) return false;
    const std::string& text = text_of(cursor);
    const bool digits =
        text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!digits) return cursor.refuse("must be 16 lower-case hex digits");
    return std::from_chars(text.data(), text.data() + text.size(), value, 16).ec == std::errc{};
}

Json Hash::write(std::uint64_t value, Encoding /*encoding*/) const {
    return to_hex(value);
}

bool Text::read(const Cursor& cursor, std::string& value) const {
    if (!expect_text(cursor)) return false;
    value = text_of(cursor);
    if (value.size() >= min_bytes && value.size() <= max_bytes) return true;
    return cursor.refuse("must be " + std::to_string(min_bytes) + " to " +
                         std::to_string(max_bytes) + " bytes of UTF-8");
}

bool PersonName::read(const Cursor& cursor, std::string& value) const {
    if (!expect_text(cursor)) return false;
    value = text_of(cursor);
    if (may_be_empty && value.empty()) return true;
    const auto fault = cursor.name_entry() ? cursor.name_entry()(value) : find_name_fault(value);
    return !fault || cursor.refuse(std::string(*fault));
}

bool JoinCode::read(const Cursor& cursor, std::string& value) const {
    if (!expect_text(cursor)) return false;
    auto code = normalize_code(text_of(cursor));
    if (!code) {
        return cursor.refuse("must be " + std::to_string(kCodeLetters) + " letters of " +
                             std::string(kCodeAlphabet));
    }
    value = *std::move(code);
    return true;
}

bool Token::read(const Cursor& cursor, std::string& value) const {
    if (!expect_text(cursor)) return false;
    value = text_of(cursor);
    if ((may_be_empty && value.empty()) || is_token(value)) return true;
    return cursor.refuse("must be " + std::to_string(kTokenHexDigits) + " lower-case hex digits");
}

bool Vector2::read(const Cursor& cursor, Vec2& value) const {
    if (!expect_array(cursor, 2, 2)) return false;
    const Number component{-limit, limit};
    return component.read(cursor.element(0), value.x) && component.read(cursor.element(1), value.y);
}

bool Direction::read(const Cursor& cursor, Vec2& value) const {
    if (!Vector2{kMaxDirectionComponent}.read(cursor, value)) return false;
    return value != Vec2{} || cursor.refuse("must not be zero");
}

bool Vector3::read(const Cursor& cursor, Vec3& value) const {
    if (!expect_array(cursor, min_count, 3)) return false;
    const SceneNumber component;
    return component.read(cursor.element(0), value.x) &&
           component.read(cursor.element(1), value.y) &&
           (cursor.json().size() < 3 || component.read(cursor.element(2), value.z));
}

bool SceneVector2::read(const Cursor& cursor, Vec2& value) const {
    if (!expect_array(cursor, 2, 2)) return false;
    const SceneNumber component;
    return component.read(cursor.element(0), value.x) && component.read(cursor.element(1), value.y);
}

}  // namespace poolhall::protocol::wire
