#pragma once

#include "shared/fields.hpp"
#include "shared/physics/scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

// The bounds of fields. What bounds one field by another is in scene_checks.cpp.
namespace poolhall::scene_checks {

using MaybeError = std::optional<SceneError>;

[[nodiscard]] inline MaybeError below(std::string step, MaybeError error) {
    if (error) error->pointer = step + error->pointer;
    return error;
}

[[nodiscard]] inline MaybeError check_value(Real x, const fields::Bounds& bounds) {
    if (bounds.hold(x)) return std::nullopt;
    return SceneError{"", bounds.above_low ? "must be positive and within its bounds"
                                           : "must be a finite number within its bounds"};
}

[[nodiscard]] inline MaybeError check_value(const Vec2& a, const fields::Bounds& bounds) {
    if (auto error = below("/0", check_value(a.x, bounds))) return error;
    return below("/1", check_value(a.y, bounds));
}

[[nodiscard]] inline MaybeError check_value(const Vec3& a, const fields::Bounds& bounds) {
    if (auto error = check_value(xy(a), bounds)) return error;
    return below("/2", check_value(a.z, bounds));
}

/// Whole numbers of `what`; sizes of text and lists.
[[nodiscard]] inline MaybeError check_count(std::size_t count, const fields::Bounds& bounds,
                                            std::string begin, std::string what) {
    if (bounds.hold(static_cast<double>(count))) return std::nullopt;
    const auto whole = [](double x) { return std::to_string(static_cast<std::size_t>(x)); };
    if (bounds.low == 0) return SceneError{"", begin + "at most " + whole(bounds.high) + what};
    return SceneError{"", begin + whole(bounds.low) + " to " + whole(bounds.high) + what};
}

[[nodiscard]] inline MaybeError check_value(std::uint32_t x, const fields::Bounds& bounds) {
    return check_count(x, bounds, "must be ", "");
}

[[nodiscard]] inline MaybeError check_value(const std::string& x, const fields::Bounds& bounds) {
    return check_count(x.size(), bounds, "must have ", " bytes");
}

template <class T>
requires std::is_enum_v<T> || std::is_same_v<T, bool> || std::is_same_v<T, BallIndex>

[[nodiscard]] MaybeError check_value(T /*any*/, const fields::Bounds& /*bounds*/) {
    return std::nullopt;
}

template <HasFieldList T>
[[nodiscard]] MaybeError check_fields(const T& object);

template <HasFieldList T>
[[nodiscard]] MaybeError check_value(const T& object, const fields::Bounds& /*bounds*/) {
    return check_fields(object);
}

template <class T>
[[nodiscard]] MaybeError check_value(const std::optional<T>& x, const fields::Bounds& bounds) {
    return x ? check_value(*x, bounds) : std::nullopt;
}

template <class T>
[[nodiscard]] MaybeError check_value(const std::vector<T>& all, const fields::Bounds& bounds) {
    if (auto error = check_count(all.size(), bounds, "must be ", "")) return error;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (auto error = check_value(all[i], bounds))
            return below("/" + std::to_string(i), std::move(error));
    }
    return std::nullopt;
}

/// The first field of the object that `wanted(field)` accepts, or of what it is made of, that is
/// out of its bounds. Pointers are from the object on.
template <HasFieldList T, class Wanted>
MaybeError check_fields_if(const T& object, Wanted wanted) {
    MaybeError first;
    for_each_field(object, [&](const auto& field, const auto& member) {
        if (first || !wanted(field)) return;
        if (auto error = check_value(member, field.bounds))
            first = below("/" + std::string(field.name), std::move(error));
    });
    return first;
}

template <HasFieldList T>
MaybeError check_fields(const T& object) {
    return check_fields_if(object, [](const auto&) { return true; });
}

/// The same of the fields of that name.
template <HasFieldList T>
[[nodiscard]] MaybeError check_field(const T& object, std::string_view name) {
    return check_fields_if(object, [name](const auto& field) { return field.name == name; });
}

}  // namespace poolhall::scene_checks
