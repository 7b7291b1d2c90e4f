#include "tests/client/desktop_view/sample_views.hpp"

#include "client/play/isolated.hpp"
#include "shared/game/end_game.hpp"

namespace poolhall::client::samples {
namespace {

constexpr double kRadius = 0.028575;
constexpr Seat kFirst{0};
constexpr Vec2 kCueSpot{end_game::kBaseLineX, 0};
constexpr Vec2 kEightSpot{end_game::kFootSpotX, 0};

ViewState with_banner(Tone tone, const std::string& title, const std::string& subtitle) {
    ViewState state = start();
    state.aim.reset();
    state.placement.reset();
    state.banner = Banner{title, subtitle, tone};
    return state;
}

ViewState won() {
    ViewState state = with_banner(Tone::kWon, "You win", "Space for another game, sides changed");
    state.balls[0].r = {0.31, 0.12};
    state.balls[1] = {"8", {end_game::kLength / 2, end_game::kWidth / 2}, true};
    state.match.seats[0].wins = 1;
    state.match.seats[1].wants_rematch = true;
    state.match.turn.reset();
    return state;
}

ViewState lost() {
    ViewState state =
        with_banner(Tone::kLost, "You lose", "The cue ball went down. Space for another game");
    state.balls[0] = {"cue", {0, -end_game::kWidth / 2}, true};
    state.balls[1].r = {-0.52, 0.2};
    state.muted = true;
    return state;
}

ViewState stepping() {
    ViewState state = start();
    state.aim.reset();
    state.placement.reset();
    state.step_mode = true;
    state.hint = "Space for the next 1/30 s";
    constexpr int kSteps = 22;
    for (int i = 0; i < kSteps; ++i) {
        const double strength = (i + 1.0) / kSteps;
        const double way = 0.040 * i;
        const bool hit = way > 0.5;
        const Vec2 cue =
            hit ? Vec2{0.116 + 0.18 * (way - 0.5), 0.9 * (way - 0.5)} : Vec2{-0.384 + way, 0.02};
        state.trail.push_back({cue, BallIndex{0}, strength});
        if (hit)
            state.trail.push_back(
                {{0.17 + 0.9 * (way - 0.5), -0.3 * (way - 0.5)}, BallIndex{1}, strength});
    }
    state.balls[0].r = state.trail[state.trail.size() - 2].r;
    state.balls[1].r = state.trail.back().r;
    return state;
}

ViewState collisions() {
    ViewState state = start();
    state.aim.reset();
    state.collision_mode = true;
    state.step_mode = true;
    state.balls[0].r = {0.62, -0.25};
    state.balls[1].r = {-0.11, 0.21};
    const double rail_y = end_game::kWidth / 2 - kRadius;
    const double rail_x = end_game::kLength / 2 - kRadius;
    for (const Vec2 r :
         {Vec2{0.36, 0.02}, Vec2{0.36 + 0.0545, 0.0372}, Vec2{0.52, -rail_y}, Vec2{rail_x, 0.17}}) {
        state.marks.push_back({r});
    }
    return state;
}

ViewState solvers() {
    ViewState state = start();
    state.aim.reset();
    state.placement.reset();
    const Vec2 corner{0.60, 0.33};
    for (int i = 0; i < 3; ++i) {
        const Vec2 end{-0.2 + 0.07 * i, -0.21 + 0.02 * i};
        state.solvers.push_back({"", "", "", i == 1, {{{-0.39, 0.1}, corner, end}}, {end}});
    }
    state.solvers[0] = {"event", "1.9 \xC2\xB5s",        "the reference",
                        false,   state.solvers[0].paths, state.solvers[0].balls};
    state.solvers[1].name = "euler 30 Hz";
    state.solvers[1].cost = "15.2 \xC2\xB5s";
    state.solvers[1].distance = "73 mm off event, other balls down";
    state.solvers[2].name = "overlap 30 Hz";
    state.solvers[2].distance = "cannot do these effects";
    return state;
}

ViewState connection_lost() {
    ViewState state = with_banner(Tone::kNeutral, "Connection lost", "Trying again in 4 s");
    state.match.link = Link::kLost;
    state.match.seats[0].connected = false;
    return state;
}

ViewState waiting() {
    ViewState state = start();
    state.match.seats[1] = {};
    state.match.turn.reset();
    state.hint = "Tell the code to the other player, or press H to play both seats";
    return state;
}

ViewState awkward_names() {
    ViewState state = aiming();
    state.match.seconds_left = 9;
    state.match.seats[0].name = "Maximiliane von und zu Hohenstein-Wittelsbach the Third";
    state.match.seats[1].name = "\xD0\x9E\xD0\xBB\xD1\x8C\xD0\xB3\xD0\xB0 \xFF\xC3 \xE2\x98\x83";
    state.status = "Saved /home/somebody/Pictures/poolhall/poolhall-0001.png";
    return state;
}

ViewState practice() {
    ViewState state = aiming();
    state.match = {};
    state.match.seats = {SeatView{"You", true, true, false, 2},
                         SeatView{"You too", true, true, false, 0}};
    state.match.turn = kFirst;
    return state;
}

/// A table of another kind, with a ball on its cloth and one in its first pocket.
ViewState on_table(const Table& table) {
    ViewState state = practice();
    state.aim.reset();
    state.placement.reset();
    state.table = table;
    state.balls = {{"cue", {-0.4, 0.1}, false}, {"8", {-table.length / 2, table.width / 2}, true}};
    return state;
}

ViewState pool_table() {
    return on_table({2.54, 1.27, true, PocketModel::kPool});
}

ViewState circles(bool rails) {
    return on_table(
        {2,
         1,
         rails,
         PocketModel::kCircles,
         {{"corner", {-0.97, 0.47}, 0.06}, {"middle", {0, 0}, 0.05}, {"edge", {0.5, -0.5}, 0.08}}});
}

/// Names of two players in scripts that DejaVu Sans has not, or that run from right to left.
ViewState named(const std::string& first, const std::string& second) {
    ViewState state = start();
    state.match.seats[0].name = isolated(first);
    state.match.seats[1].name = isolated(second);
    state.hint = isolated(first) + " is aiming";
    state.status = isolated(second) + " is back";
    return state;
}

}  // namespace

ViewState start() {
    ViewState state;
    state.table = {end_game::kLength, end_game::kWidth, true, PocketModel::kEndGame};
    state.ball_radius = kRadius;
    state.balls = {{"cue", kCueSpot, false}, {"8", kEightSpot, false}};
    const double edge = end_game::kWidth / 2 - kRadius;
    state.placement = Region{{end_game::kBaseLineX, -edge}, {end_game::kBaseLineX, edge}};
    state.aim = AimView{kCueSpot, {1, 0}, {}};
    state.match.code = "BCD-FGH";
    state.match.seats = {SeatView{"Ada", true, true, false, 0},
                         SeatView{"Grace", true, false, false, 1}};
    state.match.turn = kFirst;
    state.match.spectators = 3;
    state.match.link = Link::kOnline;
    state.match.round_trip_ms = 23;
    state.hint = "Space to shoot";
    return state;
}

ViewState aiming() {
    ViewState state = start();
    Scene scene;
    scene.table = state.table;
    scene.ball.radius = kRadius;
    const Vec2 cue{end_game::kBaseLineX, 0.12};
    const Vec2 eight{0.34, -0.06};
    scene.balls = {{"cue", {{cue.x, cue.y, 0}, {}, {}}}, {"8", {{eight.x, eight.y, 0}, {}, {}}}};
    state.balls = {{"cue", cue, false}, {"8", eight, false}};
    const Vec2 direction = eight + Vec2{0, 0.028} - cue;
    state.aim = AimView{cue, direction, predict(scene, BallIndex{0}, direction)};
    state.frames_per_second = 60;
    state.status = "Saved poolhall-001.png";
    return state;
}

std::vector<NamedView> all() {
    std::vector<NamedView> views = {
        {"start", start()},
        {"aiming", aiming()},
        {"step-trail", stepping()},
        {"collision-marks", collisions()},
        {"solvers", solvers()},
        {"won", won()},
        {"lost", lost()},
        {"help", aiming(), {1280, 720}, true},
        {"connection-lost", connection_lost()},
        {"waiting", waiting()},
        {"practice", practice()},
        {"names", awkward_names()},
        {"pool-table", pool_table()},
        {"circles", circles(true)},
        {"circles-without-rails", circles(false)},
        {"carom", on_table({2.84, 1.42, true, PocketModel::kNone})},
        {"names-arabic-hebrew", named("محمد العربي", "שרה לוי!")},
        {"names-chinese-japanese", named("王小明", "さくら 山田")},
        {"names-korean-thai", named("김철수", "สมชาย ใจดี")},
        {"names-devanagari-emoji", named("प्रिया शर्मा", "Ann 🎱👩‍🚀🇨🇭")},
    };
    const auto sized = [&views](const std::string& name, ViewState state, SDL_Point size) {
        views.push_back({name, std::move(state), size, false});
    };
    sized("tiny", aiming(), {480, 320});
    views.push_back({"tiny-help", aiming(), {480, 320}, true});
    sized("tiny-lost", lost(), {480, 320});
    sized("tiny-solvers", solvers(), {480, 320});
    sized("wide", collisions(), {1400, 420});
    sized("tall", awkward_names(), {600, 1000});
    sized("hidpi", stepping(), {2560, 1440});
    sized("hidpi-pool-table", pool_table(), {2560, 1440});
    sized("huge", aiming(), {3840, 2160});
    return views;
}

}  // namespace poolhall::client::samples
