#include "client/desktop/audio/synth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace poolhall::client {
namespace {

constexpr float kTurn = 2 * std::numbers::pi_v<float>;

std::vector<float> silence(float seconds) {
    std::vector<float> samples(static_cast<std::size_t>(seconds * kSampleRate));
    return samples;
}

// A struck body's mode: a sine that dies away.
struct Mode {
    float hz;
    float level;
    float decay;      ///< s until it has fallen to 1/e
    float start = 0;  ///< s
};

void add_mode(std::vector<float>& samples, const Mode& mode) {
    const auto first = static_cast<std::size_t>(mode.start * kSampleRate);
    for (std::size_t i = first; i < samples.size(); ++i) {
        const float t = static_cast<float>(i - first) / kSampleRate;
        const float attack = std::min(t / 0.0008F, 1.0F);  // no crack at the start
        samples[i] +=
            mode.level * attack * std::exp(-t / mode.decay) * std::sin(kTurn * mode.hz * t);
    }
}

// Noise through a one-pole low pass, dying away: cloth, leather, chalk.
struct Burst {
    float level;
    float decay;       ///< s
    float smoothness;  ///< 0 white, towards 1 duller
    float start = 0;   ///< s
};

void add_burst(std::vector<float>& samples, const Burst& burst) {
    std::uint32_t random = 0x2545F491U;
    float low = 0;
    const auto first = static_cast<std::size_t>(burst.start * kSampleRate);
    for (std::size_t i = first; i < samples.size(); ++i) {
        random ^= random << 13U;
        random ^= random >> 17U;
        random ^= random << 5U;
        const float white = static_cast<float>(random >> 8U) / 8388608.0F - 1;
        low = burst.smoothness * low + (1 - burst.smoothness) * white;
        const float t = static_cast<float>(i - first) / kSampleRate;
        samples[i] += burst.level * std::min(t / 0.0005F, 1.0F) * std::exp(-t / burst.decay) * low;
    }
}

std::vector<float> cue() {
    auto samples = silence(0.16F);
    add_burst(samples, {0.9F, 0.006F, 0.55F});
    add_mode(samples, {620, 0.55F, 0.014F});
    add_mode(samples, {1450, 0.30F, 0.008F});
    add_mode(samples, {190, 0.35F, 0.030F});
    return samples;
}

std::vector<float> click(int pitch) {
    const float bright = 1 + 0.14F * static_cast<float>(pitch);
    auto samples = silence(0.12F);
    add_mode(samples, {1850 * bright, 0.55F, 0.010F});
    add_mode(samples, {3240 * bright, 0.40F * bright, 0.006F});
    add_mode(samples, {5900 * bright, 0.16F * bright, 0.003F});
    add_burst(samples, {0.35F, 0.0025F, 0.15F});
    return samples;
}

std::vector<float> rail() {
    auto samples = silence(0.30F);
    add_mode(samples, {96, 0.80F, 0.050F});
    add_mode(samples, {173, 0.40F, 0.030F});
    add_burst(samples, {0.9F, 0.022F, 0.90F});
    return samples;
}

// The drop, then the ball knocking about in the pocket.
std::vector<float> pocket() {
    auto samples = silence(0.75F);
    add_burst(samples, {1.1F, 0.040F, 0.93F});
    add_mode(samples, {118, 0.65F, 0.070F});
    constexpr std::array kKnocks{0.11F, 0.21F, 0.285F, 0.34F};
    float level = 0.42F;
    for (const float at : kKnocks) {
        add_mode(samples, {410, level, 0.018F, at});
        add_mode(samples, {980, 0.4F * level, 0.008F, at});
        level *= 0.66F;
    }
    return samples;
}

std::vector<float> tune(const std::vector<float>& notes_hz, float spacing) {
    auto samples = silence(spacing * static_cast<float>(notes_hz.size()) + 0.9F);
    for (std::size_t i = 0; i < notes_hz.size(); ++i) {
        const float start = spacing * static_cast<float>(i);
        add_mode(samples, {notes_hz[i], 0.42F, 0.30F, start});
        add_mode(samples, {2 * notes_hz[i], 0.14F, 0.16F, start});
        add_mode(samples, {3 * notes_hz[i], 0.05F, 0.09F, start});
    }
    return samples;
}

// Into -0.9 to 0.9, the last 20 ms faded out so that the end cannot be heard.
void finish(std::vector<float>& samples) {
    float peak = 1e-6F;
    for (const float s : samples)
        peak = std::max(peak, std::abs(s));
    constexpr float kFade = 0.02F * kSampleRate;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto left = static_cast<float>(samples.size() - 1 - i);
        samples[i] *= 0.9F / peak * std::min(left / kFade, 1.0F);
    }
}

std::vector<float> raw(Sound sound, int pitch) {
    switch (sound) {
        case Sound::kCue:
            return cue();
        case Sound::kClick:
            return click(pitch);
        case Sound::kRail:
            return rail();
        case Sound::kPocket:
            return pocket();
        case Sound::kWon:
            return tune({523.25F, 659.26F, 783.99F, 1046.5F}, 0.13F);  // C E G C
        case Sound::kLost:
            return tune({392.0F, 349.23F, 311.13F, 261.63F}, 0.19F);  // G F E-flat C
    }
    return silence(0.01F);
}

}  // namespace

std::vector<float> synthesise(Sound sound, int pitch) {
    std::vector<float> samples = raw(sound, std::clamp(pitch, 0, kClickPitches - 1));
    finish(samples);
    return samples;
}

std::vector<std::int16_t> to_stereo(const std::vector<float>& samples) {
    std::vector<std::int16_t> result;
    result.reserve(2 * samples.size());
    for (const float s : samples) {
        const auto value =
            static_cast<std::int16_t>(std::lround(32767 * std::clamp(s, -1.0F, 1.0F)));
        result.insert(result.end(), {value, value});
    }
    return result;
}

}  // namespace poolhall::client
