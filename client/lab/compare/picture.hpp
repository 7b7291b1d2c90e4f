#pragma once

#include "client/compare/comparison.hpp"
#include "shared/result.hpp"

#include <cstdint>
#include <string>

namespace poolhall::lab {

enum class PictureFormat : std::uint8_t { kSvg, kPng };

struct PictureError {
    std::string reason;
};

/// The bytes of a picture of all paths on one table, to scale: a colour, a dash and a width a
/// solver, so that equal ways show as stripes; crosses where balls met something, and below the
/// table what each solver costs and how far it is from the reference. The scene must be that of the
/// comparison, which must have a reference.
[[nodiscard]] Result<std::string, PictureError> picture_of(const Scene& scene,
                                                           const compare::Comparison& comparison,
                                                           PictureFormat format);

}  // namespace poolhall::lab
