#pragma once

#include <cstdint>

namespace poolhall {

/// Raised whenever a golden hash changes: shots of one edition are the same to the last bit
/// everywhere, shots of two need not be.
inline constexpr std::uint32_t kPhysicsEdition = 2;

}  // namespace poolhall
