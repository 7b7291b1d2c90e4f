#pragma once

#include "client/desktop/audio/sounds.hpp"

#include <cstdint>
#include <vector>

namespace poolhall::client {

inline constexpr int kSampleRate = 44100;  ///< 1/s
inline constexpr int kClickPitches = 4;    ///< from a soft, dull touch to a hard, bright knock

/// The sound's samples, one channel, -1 to 1, ending in silence. `pitch` 0 to kClickPitches - 1
/// counts for clicks only.
[[nodiscard]] std::vector<float> synthesise(Sound sound, int pitch = 0);

/// Two channels alike, 16 bits, as the mixer plays them.
[[nodiscard]] std::vector<std::int16_t> to_stereo(const std::vector<float>& samples);

}  // namespace poolhall::client
