#pragma once

#include "client/play/link.hpp"
#include "shared/aim/prediction.hpp"
#include "shared/game/legal.hpp"
#include "shared/game/seat.hpp"
#include "shared/physics/scene/scene.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// What one frame of the window shows. The app fills it, the view draws it; neither keeps the
// other's state.
namespace poolhall::client {

struct BallView {
    std::string id;  ///< "cue", "8"
    Vec2 r;          ///< centre, m
    bool sunk = false;
};

struct AimView {
    Vec2 from;       ///< centre of the cue ball, m
    Vec2 direction;  ///< of any length but zero
    AimPrediction prediction;
};

/// A ring where a ball was, one a step of step mode; it fades.
struct TrailRing {
    Vec2 r;  ///< m
    BallIndex ball;
    double strength = 1;  ///< 1 new, 0 gone
};

/// Where a ball was at a time of impact (collision mode).
struct CollisionMark {
    Vec2 r;  ///< m
};

/// The last shot as one solver has it.
struct SolverView {
    std::string name;                      ///< "euler 30 Hz"
    std::string cost;                      ///< "15.2 µs"; empty where it cannot do the scene
    std::string distance;                  ///< in the end, from the most accurate: "12 mm off"
    bool decides = false;                  ///< the solver that the game is played by
    std::vector<std::vector<Vec2>> paths;  ///< corners of the way of each ball that moves, m
    std::vector<Vec2> balls;               ///< where those balls are at the time that is shown, m
};

enum class Tone : std::uint8_t { kNeutral, kWon, kLost };

/// The large message over the table.
struct Banner {
    std::string title;
    std::string subtitle;
    Tone tone = Tone::kNeutral;
};

struct SeatView {
    std::string name;  ///< empty: the seat is open
    bool connected = false;
    bool mine = false;
    bool wants_rematch = false;
    std::uint32_t wins = 0;
};

/// Who plays, and over what.
struct MatchView {
    std::string code;  ///< join code as people read it, "BCD-FGH"; empty in practice
    std::array<SeatView, kSeatCount> seats;
    std::optional<Seat> turn;
    std::optional<std::uint32_t> seconds_left;  ///< of the turn, where a shot clock runs
    std::uint32_t spectators = 0;
    Link link = Link::kOffline;
    std::optional<double> round_trip_ms;
};

/// As many solvers as can be told apart.
inline constexpr std::size_t kSolverViews = 3;

struct ViewState {
    Table table;
    double ball_radius = 0.028575;  ///< m
    std::vector<BallView> balls;
    std::optional<Region> placement;  ///< where the centre of the cue ball in hand may be put, m
    std::optional<AimView> aim;       ///< none while balls move
    std::vector<TrailRing> trail;
    std::vector<CollisionMark> marks;
    std::vector<SolverView> solvers;  ///< the same shot by others; up to kSolverViews, or none
    MatchView match;
    std::optional<Banner> banner;
    std::string status;  ///< one line: "Saved shot-001.png"; empty for none
    std::string hint;    ///< what to do now: "Space to shoot"; empty for none
    bool step_mode = false;
    bool collision_mode = false;
    bool muted = false;
    std::optional<double> frames_per_second;  ///< shown when set; 0 while nothing moves
    std::string physics;                      ///< physics_of(); not shown when empty
};

}  // namespace poolhall::client
