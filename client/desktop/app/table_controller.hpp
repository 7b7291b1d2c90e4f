#pragma once

#include "client/desktop/app/input.hpp"
#include "client/desktop/app/solver_overlay.hpp"
#include "client/desktop/app/step_mode.hpp"
#include "client/play/overlays.hpp"
#include "client/play/placing.hpp"
#include "client/play/shown_table.hpp"

#include <string>
#include <variant>
#include <vector>

namespace poolhall::client {

struct GameEnded {
    Tone tone = Tone::kNeutral;
};

/// Something to be heard.
using TableSound = std::variant<ShotEvent, GameEnded>;

/// Turns keys, mouse and time into commands to the match, and all that is known into what one frame
/// shows. It needs neither window nor sound.
class TableController {
  public:
    TableController(ClientMatch& match, Playback& playback);

    static constexpr double kNewGamePause = 3;  ///< s after a practice game has ended
    static constexpr double kStatusTime = 4;    ///< s that a status line stays

    /// The actions that belong to the match; those of the window and its screens are ignored.
    void act(Action action);
    /// Lets `dt` s pass until `now` (s) with the keys held as given.
    void update(double dt, double now, const Steering& steering);

    // The mouse, in metres on the table.
    void pointer_moved(Vec2 r);
    void pointer_pressed(Vec2 r);
    void pointer_released();

    void show_status(std::string line);

    /// With the frame rate, where that is to be shown; but for what is not the table's: sound.
    [[nodiscard]] ViewState view(std::optional<double> frames_per_second = std::nullopt) const;
    /// Who plays, and over what.
    [[nodiscard]] MatchView match_view() const;
    /// What became audible since the last call.
    [[nodiscard]] std::vector<TableSound> take_sounds();

    /// Something on the screen changes by itself from frame to frame.
    [[nodiscard]] bool animated() const;

    /// Rises whenever what view() gives may have changed.
    [[nodiscard]] std::uint64_t revision() const { return revision_ + match_.info().revision; }

  private:
    void go();
    void take_step();
    void steer(double dt, const Steering& steering);
    void aim_at(Vec2 r);
    void advance(double dt);
    void take_passed();
    /// Shows the match and the playback as they are now; a result that comes into sight is heard.
    void refresh();
    void pause_before_new_game();

    [[nodiscard]] bool practice() const { return match_.info().link == Link::kOffline; }

    /// The last step of step mode has been taken; the aim comes back when that has been seen.
    [[nodiscard]] bool at_end_of_shot() const;
    /// Someone here may aim, place and shoot now.
    [[nodiscard]] bool acting() const;
    [[nodiscard]] Vec2 cue_ball() const;
    [[nodiscard]] std::optional<AimView> aim_view() const;
    [[nodiscard]] std::vector<SolverView> solver_views() const;
    /// Of the shot clock, in whole seconds that have begun; none while none runs or balls move.
    [[nodiscard]] std::optional<std::uint32_t> seconds_left() const;

    ClientMatch& match_;
    Playback& playback_;
    ShownTable shown_;
    Placing placing_;
    StepTrail trail_;
    SolverOverlay solvers_;
    StepMode step_mode_;
    std::vector<TableSound> sounds_;

    std::optional<double> ended_at_;  ///< when the end of the game was seen, s
    std::string status_;
    double status_until_ = 0;
    std::optional<std::uint32_t> seconds_shown_;
    double now_ = 0;
    std::uint64_t revision_ = 0;
};

}  // namespace poolhall::client
