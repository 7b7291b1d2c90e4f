#include "client/desktop/audio/sounds.hpp"

#include "client/desktop/audio/synth.hpp"

#include <SDL2/SDL.h>
#include <SDL2/SDL_mixer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace poolhall::client {
namespace {

constexpr int kChannels = 16;
constexpr int kBufferFrames = 512;  // 12 ms: a click is heard with the collision that is seen

struct FreeChunk {
    void operator()(Mix_Chunk* chunk) const { Mix_FreeChunk(chunk); }
};

// A chunk refers to its samples, so they stay with it.
struct Clip {
    std::vector<std::int16_t> samples;
    std::unique_ptr<Mix_Chunk, FreeChunk> chunk;
};

Clip make_clip(Sound sound, int pitch) {
    Clip clip{to_stereo(synthesise(sound, pitch)), nullptr};
    const auto bytes = static_cast<Uint32>(clip.samples.size() * sizeof(std::int16_t));
    // The mixer takes the samples as bytes; it only reads them.
    clip.chunk.reset(Mix_QuickLoad_RAW(reinterpret_cast<Uint8*>(clip.samples.data()), bytes));
    return clip;
}

std::string open_device() {
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) return SDL_GetError();
    // Neither rate, format nor channels may change: the clips are made for them.
    if (Mix_OpenAudioDevice(kSampleRate, AUDIO_S16SYS, 2, kBufferFrames, nullptr, 0) == 0)
        return {};
    std::string reason = Mix_GetError();
    SDL_QuitSubSystem(SDL_INIT_AUDIO);
    return reason;
}

double clamped(double value, double low, double high) {
    return std::isfinite(value) ? std::clamp(value, low, high) : low;
}

}  // namespace

struct Sounds::Device {
    Device();
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] Mix_Chunk* clip(Sound sound, double strength);

    std::array<Clip, kSoundCount> clips;
    std::array<Clip, kClickPitches> clicks;
};

Sounds::Device::Device() {
    Mix_AllocateChannels(kChannels);
    for (int i = 0; i < kSoundCount; ++i)
        clips[static_cast<std::size_t>(i)] = make_clip(static_cast<Sound>(i), 0);
    for (int i = 0; i < kClickPitches; ++i)
        clicks[static_cast<std::size_t>(i)] = make_clip(Sound::kClick, i);
}

Sounds::Device::~Device() {
    Mix_HaltChannel(-1);
    clips = {};
    clicks = {};
    Mix_CloseAudio();
    SDL_QuitSubSystem(SDL_INIT_AUDIO);
}

Mix_Chunk* Sounds::Device::clip(Sound sound, double strength) {
    if (sound != Sound::kClick) return clips[static_cast<std::size_t>(sound)].chunk.get();
    const auto pitch = static_cast<std::size_t>(strength * kClickPitches);
    return clicks[std::min(pitch, clicks.size() - 1)].chunk.get();
}

Sounds::Sounds() {
    if (const std::string reason = open_device(); !reason.empty()) {
        SDL_Log("no sound: %s", reason.c_str());
        return;
    }
    device_ = std::make_unique<Device>();
}

Sounds::~Sounds() = default;

void Sounds::play(Sound sound, double strength, double pan) {
    const double loud = clamped(strength, 0, 1);
    if (!device_ || muted_ || loud == 0) return;
    Mix_Chunk* chunk = device_->clip(sound, loud);
    const int channel = chunk != nullptr ? Mix_PlayChannel(-1, chunk, 0) : -1;
    if (channel < 0) return;  // sixteen sound already: one more could not be told from them
    // The ear takes loudness by its square root; three quarters of the way out is far enough to the
    // side.
    Mix_Volume(channel, static_cast<int>(std::lround(MIX_MAX_VOLUME * std::sqrt(loud))));
    const double side = 0.75 * clamped(std::isfinite(pan) ? pan : 0, -1, 1);
    const auto level = [](double part) {
        return static_cast<Uint8>(std::lround(255 * std::min(part, 1.0)));
    };
    Mix_SetPanning(channel, level(1 - side), level(1 + side));
}

void Sounds::set_muted(bool muted) {
    muted_ = muted;
    if (device_ && muted) Mix_HaltChannel(-1);
}

}  // namespace poolhall::client
