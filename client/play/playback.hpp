#pragma once

#include "client/play/shot_timeline.hpp"
#include "shared/game/game_state.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <variant>
#include <vector>

namespace poolhall::client {

/// How playback keeps pace with what it is fed.
enum class Pacing : std::uint8_t {
    kSteady,  ///< whole shots are known at once: real time, from the first moment
    kLive,    ///< ticks arrive over a network: a little behind the newest, catching up when far
              ///< behind
};

/// A shot while it is shown.
struct Shot {
    std::uint32_t number = 0;  ///< from 1, within the match
    Scene scene;               ///< with its strike
    BallIndex cue_ball;
    ShotTimeline timeline;
    std::optional<Ruling> ruling;  ///< known when the timeline is complete

    /// The ruling, if it is certain at `t`, s.
    [[nodiscard]] std::optional<Ruling> ruling_at(double t) const;
};

/// Plays shots one after the other at the display's rate while they are still being received. It
/// never shows anything but what was received: where nothing is known yet, balls stand still rather
/// than run through a rail.
class Playback {
  public:
    explicit Playback(Pacing pacing) : pacing_(pacing) {}

    // ---- fed by the match
    void begin(Shot shot);
    /// The newest shot, to extend or finish; null when nothing is being played.
    [[nodiscard]] Shot* newest();
    void clear();

    // ---- driven by the display
    /// Lets `dt` s of real time pass.
    void advance(double dt);
    /// That many steps of exactly kStep, or what is left of the shot; backwards if negative. False
    /// if so much has not been received yet, or if there is nothing before.
    bool step(int count = 1);
    static constexpr double kStep = 1.0 / 30;  ///< s
    /// Shows the shot at `t` s, before or after what is shown now, held within the known time. At
    /// its end the shot stays until time passes, or a step.
    void seek(double t);

    /// The shot that is shown; null when all has been played.
    [[nodiscard]] const Shot* shot() const { return shots_.empty() ? nullptr : &shots_.front(); }

    [[nodiscard]] double time() const { return time_; }  ///< s since its strike

    [[nodiscard]] bool idle() const { return shots_.empty(); }

    /// The ruling of the shot that is shown, once it is certain at the time that is shown.
    [[nodiscard]] std::optional<Ruling> ruling() const;

    struct ShotBegan {};

    /// Time ran backwards over it.
    struct TakenBack {
        ShotEvent event;
    };

    struct ShotFinished {
        Shot shot;
    };

    using Passed = std::variant<ShotBegan, ShotEvent, TakenBack, ShotFinished>;
    /// What playback passed since the last call, in order.
    [[nodiscard]] std::vector<Passed> take_passed();

  private:
    /// Without the shot's end, even there.
    void show(double t);
    void move_to(double t);
    void end_shot();
    void show_first();
    [[nodiscard]] double unplayed() const;
    [[nodiscard]] double rate(double dt);

    Pacing pacing_;
    std::deque<Shot> shots_;
    double time_ = 0;
    std::size_t next_event_ = 0;  ///< of the shot that is shown: those before it have been passed
    bool started_ = false;        ///< the first shot has left its first moment
    double delay_ = 2 * kStep;    ///< s that live playback keeps behind the newest tick
    bool starved_ = false;        ///< live playback has come to the end of what is known
    std::vector<Passed> passed_;
};

}  // namespace poolhall::client
