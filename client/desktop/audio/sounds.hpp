#pragma once

#include <cstdint>
#include <memory>

namespace poolhall::client {

enum class Sound : std::uint8_t { kCue, kClick, kRail, kPocket, kWon, kLost };

inline constexpr int kSoundCount = 6;

/// The sounds of the table, made by the program. Without an audio device everything works and
/// nothing is heard.
class Sounds {
  public:
    /// Opens the default audio device; where there is none, logs one line.
    Sounds();
    ~Sounds();
    Sounds(const Sounds&) = delete;
    Sounds& operator=(const Sounds&) = delete;

    /// `strength` 0 (not heard) to 1 sets loudness and, for clicks, pitch; `pan` -1 (left) to 1
    /// (right). Values beyond are clamped.
    void play(Sound sound, double strength, double pan);
    void set_muted(bool muted);

    [[nodiscard]] bool muted() const { return muted_; }

    /// There is a device to play on.
    [[nodiscard]] bool available() const { return device_ != nullptr; }

  private:
    struct Device;
    std::unique_ptr<Device> device_;
    bool muted_ = false;
};

}  // namespace poolhall::client
