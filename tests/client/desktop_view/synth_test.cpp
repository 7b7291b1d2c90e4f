#include "client/desktop/audio/synth.hpp"

#include <SDL2/SDL_stdinc.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace poolhall::client {
namespace {

double energy(const std::vector<float>& samples) {
    double sum = 0;
    for (const float s : samples)
        sum += static_cast<double>(s) * static_cast<double>(s);
    return sum;
}

// Crossings of zero a second: how high a sound is.
double brightness(const std::vector<float>& samples) {
    int crossings = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
        crossings += (samples[i] < 0) != (samples[i - 1] < 0) ? 1 : 0;
    return static_cast<double>(crossings) * kSampleRate / static_cast<double>(samples.size());
}

TEST(SynthTest, EverySoundIsLoudBoundedAndEndsInSilence) {
    for (int i = 0; i < kSoundCount; ++i) {
        const auto samples = synthesise(static_cast<Sound>(i));
        const float peak =
            std::abs(*std::max_element(samples.begin(), samples.end(),
                                       [](float a, float b) { return std::abs(a) < std::abs(b); }));
        EXPECT_NEAR(peak, 0.9, 0.05) << i;
        EXPECT_LT(std::abs(samples.front()), 0.01) << i;
        EXPECT_LT(std::abs(samples.back()), 0.001) << i;
        EXPECT_LT(samples.size(), 3U * kSampleRate) << i;
        EXPECT_GT(energy(samples), 1) << i;
    }
}

TEST(SynthTest, HarderClicksAreBrighter) {
    for (int pitch = 1; pitch < kClickPitches; ++pitch)
        EXPECT_GT(brightness(synthesise(Sound::kClick, pitch)),
                  brightness(synthesise(Sound::kClick, pitch - 1)))
            << pitch;
}

TEST(SynthTest, ARailIsDullerThanAClick) {
    EXPECT_LT(brightness(synthesise(Sound::kRail)), 0.5 * brightness(synthesise(Sound::kClick)));
}

TEST(SynthTest, StereoHoldsEachSampleTwice) {
    const auto stereo = to_stereo({0, 1, -1, 0.5F});
    EXPECT_EQ(stereo,
              (std::vector<std::int16_t>{0, 0, 32767, 32767, -32767, -32767, 16384, 16384}));
}

void play_everything(Sounds& sounds) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int round = 0; round < 5; ++round) {
        for (int i = 0; i < kSoundCount; ++i) {
            sounds.play(static_cast<Sound>(i), 1, -1);
            sounds.play(static_cast<Sound>(i), 5, 7);
            sounds.play(static_cast<Sound>(i), nan, nan);
        }
    }
    sounds.set_muted(true);
    EXPECT_TRUE(sounds.muted());
    sounds.play(Sound::kWon, 1, 0);
    sounds.set_muted(false);
    sounds.play(Sound::kWon, 1, 0);
}

TEST(SoundsTest, PlaysOnADevice) {
    SDL_setenv("SDL_AUDIODRIVER", "dummy", 1);
    Sounds sounds;
    EXPECT_TRUE(sounds.available());
    play_everything(sounds);
}

TEST(SoundsTest, WithoutADeviceNothingHappens) {
    SDL_setenv("SDL_AUDIODRIVER", "no such driver", 1);
    Sounds sounds;
    EXPECT_FALSE(sounds.available());
    play_everything(sounds);
}

}  // namespace
}  // namespace poolhall::client
