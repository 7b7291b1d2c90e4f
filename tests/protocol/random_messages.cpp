#include "tests/protocol/random_messages.hpp"

#include "protocol/limits.hpp"
#include "protocol/messages.hpp"
#include "shared/physics/check.hpp"

#include <array>
#include <string>
#include <string_view>

namespace poolhall::protocol::testing {
namespace {

template <class E>
E any_of(Random& random) {
    for (;;) {
        const E value = kValues<E>[random.below(kCount<E>)];
        if (!poolhall::name(value).empty()) return value;
    }
}

std::uint32_t number(Random& random) {
    return static_cast<std::uint32_t>(random.word() >> (32 + random.below(32)));
}

Seat seat(Random& random) {
    return Seat{static_cast<std::uint8_t>(random.below(kSeatCount))};
}

/// Player names of several scripts, with what must be escaped in JSON.
std::string person(Random& random) {
    static constexpr std::array<std::string_view, 6> kNames{"Ann",     "Jürgen Ö.", "李小龍",
                                                            "a\"b\\c", "🎱 shark",   "x y"};
    return std::string(kNames[random.below(kNames.size())]);
}

std::string sentence(Random& random) {
    return "reason " + std::to_string(random.word()) + " of " + person(random) + "\n";
}

std::string from_alphabet(Random& random, std::string_view alphabet, std::size_t length) {
    std::string text;
    for (std::size_t i = 0; i < length; ++i)
        text += alphabet[random.below(alphabet.size())];
    return text;
}

std::string code(Random& random) {
    return from_alphabet(random, kCodeAlphabet, kCodeLetters);
}

std::string token(Random& random) {
    return from_alphabet(random, "0123456789abcdef", kTokenHexDigits);
}

Vec2 vec2(Random& random, double limit) {
    return {random.real(limit), random.real(limit)};
}

Vec3 vec3(Random& random, double limit) {
    return {random.real(limit), random.real(limit), random.real(limit)};
}

/// Not zero but for a chance that never comes.
Vec2 direction(Random& random) {
    return vec2(random, kMaxDirectionComponent);
}

BallState state(Random& random) {
    return {vec3(random, 2), vec3(random, 30), vec3(random, 500)};
}

Ruling ruling(Random& random) {
    Ruling result{any_of<Verdict>(random), seat(random), seat(random), {}, random.real(1) + 1};
    if (random.coin()) result.winner = seat(random);
    return result;
}

SeatInfo seat_info(Random& random) {
    if (random.coin()) return {};
    return {true, random.coin(), person(random), random.coin(), number(random)};
}

double positive(Random& random, double limit) {
    return limit / 2 + random.real(limit / 2);
}

Table table_of_scene(Random& random) {
    Table table{4 + random.real(1), 3 + random.real(1), true, any_of<PocketModel>(random)};
    if (random.coin()) return table;
    table.pockets = PocketModel::kCircles;
    for (std::size_t i = random.below(4); i > 0; --i)
        table.circles.push_back(
            {person(random) + std::to_string(i), vec2(random, 2), positive(random, 0.1)});
    return table;
}

BallBallSpec ball_ball(Random& random) {
    BallBallSpec spec{any_of<BallBallModel>(random),
                      positive(random, 1),
                      positive(random, 0.1),
                      {},
                      positive(random, 1e-3)};
    if (random.coin())
        spec.friction_by_speed =
            FrictionBySpeed{positive(random, 0.1), positive(random, 0.1), positive(random, 2)};
    return spec;
}

Effects effects(Random& random) {
    Effects result;
    if (random.coin())
        result.linear_drag = LinearDragSpec{positive(random, 1), positive(random, 0.2)};
    if (random.coin()) result.sliding = SlidingSpec{positive(random, 0.5)};
    if (random.coin()) result.rolling = RollingSpec{positive(random, 0.05)};
    if (random.coin()) result.spin_decay = SpinDecaySpec{positive(random, 0.05)};
    result.ball_ball = ball_ball(random);
    result.rail = {any_of<RailModel>(random), positive(random, 1), positive(random, 0.5),
                   0.02 + positive(random, 0.02)};
    if (random.coin()) result.airborne = AirborneSpec{positive(random, 1)};
    return result;
}

/// What a client may write; not all of it is fit for a game.
std::optional<MatchSettings> settings(Random& random) {
    if (random.coin()) return std::nullopt;
    MatchSettings result;
    if (random.coin()) result.game.effects = effects(random);
    if (random.coin())
        result.game.solver = SolverSpec{any_of<SolverKind>(random), positive(random, 1000)};
    result.race_to = number(random);
    result.breaks = any_of<BreakOrder>(random);
    if (random.coin()) result.shot_clock_s = number(random);
    result.turns = any_of<Turns>(random);
    return result;
}

GameState game_state(Random& random) {
    GameState result;
    result.scene = random_scene(random, false);
    const std::size_t balls = result.scene.balls.size();
    result.cue_ball = BallIndex{static_cast<std::uint16_t>(random.below(balls))};
    result.turn = seat(random);
    result.shots = number(random);
    result.over = random.coin();
    if (result.over && random.coin()) result.winner = seat(random);
    result.part = EndGamePart{random.coin()};
    return result;
}

Legal legal(Random& random) {
    Legal result;
    result.seat = seat(random);
    result.aim = direction(random);
    if (random.coin()) {
        const Vec2 low = vec2(random, 2);
        result.place = Region{low, low + Vec2{positive(random, 1), positive(random, 1)}};
    }
    if (random.coin()) {
        const double least = positive(random, 5);
        const double own = least + positive(random, 5);
        result.shoot = StrokeBounds{least, own + positive(random, 5), own, positive(random, 1),
                                    positive(random, 10)};
    }
    return result;
}

TableState table(Random& random) {
    TableState result;
    result.match = "m" + std::to_string(random.word());
    result.code = code(random);
    result.game = "end_game";
    result.settings = settings(random);
    result.phase = any_of<Phase>(random);
    result.game_number = number(random);
    result.shot = number(random);
    result.seats = {seat_info(random), seat_info(random)};
    result.spectators = number(random);
    result.state = game_state(random);
    result.legal = legal(random);
    result.aim = direction(random);
    if (random.coin()) result.cue = vec2(random, 2);
    if (random.coin()) result.ruling = ruling(random);
    if (random.coin()) result.winner = seat(random);
    if (random.coin()) result.clock_left_ms = number(random);
    const std::size_t balls = result.state.scene.balls.size();
    if (result.phase == Phase::kPlaying) {
        result.live = LiveShot{result.shot, number(random), std::vector<Vec2>(balls)};
        for (Vec2& r : result.live->balls)
            r = vec2(random, 2);
    }
    return result;
}

BallIndex ball_index(Random& random) {
    return BallIndex{static_cast<std::uint16_t>(random.below(kMaxBalls))};
}

ShotEvent event(Random& random) {
    ShotEvent result;
    result.t = random.real(10) + 10;
    result.kind = any_of<EventKind>(random);
    result.ball_count = result.kind == EventKind::kBallBall ? 2 : 1;
    if (result.kind == EventKind::kBallRail) result.rail = any_of<Rail>(random);
    if (result.kind == EventKind::kBallPocket) result.pocket = any_of<Pocket>(random);
    for (std::size_t i = 0; i < result.ball_count; ++i) {
        result.balls[i] = ball_index(random);
        result.before[i] = state(random);
        result.after[i] = state(random);
    }
    return result;
}

FinalBall final_ball(Random& random) {
    FinalBall result{any_of<Motion>(random), {}, state(random)};
    if (result.motion == Motion::kPocketed) result.pocket = any_of<Pocket>(random);
    return result;
}

/// A position that neither rounding to 10 um nor single precision changes: a multiple of 1/32 m.
Vec2 display_position(Random& random) {
    const auto coordinate = [&] { return (static_cast<double>(random.below(129)) - 64) / 32; };
    const double x = coordinate();
    return {x, coordinate()};
}

Frame frame(Random& random) {
    Frame result{number(random), number(random), {}, {}};
    for (std::size_t i = random.below(4); i > 0; --i)
        result.balls.push_back({ball_index(random), display_position(random)});
    for (std::size_t i = random.below(4); i > 0; --i)
        result.events.push_back(event(random));
    return result;
}

Joined joined(Random& random) {
    Joined result{number(random) | 1U, {}, {}, table(random)};
    if (random.coin()) {
        result.token = token(random);
        result.seats = {seat(random)};
    }
    return result;
}

ShotStarted shot_started(Random& random) {
    ShotStarted result{number(random), seat(random), random_scene(random, true), random.word(), {}};
    if (random.coin()) result.final_hash = random.word();
    return result;
}

ShotEnded shot_ended(Random& random) {
    ShotEnded result;
    result.shot = number(random);
    result.ticks = number(random);
    result.duration = random.real(10) + 10;
    result.outcome = any_of<Outcome>(random);
    result.kernel = "drag";
    for (std::size_t i = random.below(4); i > 0; --i)
        result.effects.push_back({"sliding", {}, random.coin()});
    if (random.coin()) result.effects.push_back({"airborne", any_of<Bound>(random), false});
    result.solver = any_of<SolverKind>(random);
    result.cpu_us = random.real(10) + 10;
    for (std::size_t i = random.below(4); i > 0; --i)
        result.balls.push_back(final_ball(random));
    result.hash = random.word();
    result.ruling = ruling(random);
    result.table = table(random);
    return result;
}

/// Any solver that can do what the scene asks for.
SolverKind fitting_solver(Random& random, Scene scene) {
    for (;;) {
        scene.solver.kind = any_of<SolverKind>(random);
        if (!check(scene)) return scene.solver.kind;
    }
}

}  // namespace

std::uint64_t Random::word() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
}

std::size_t Random::below(std::size_t bound) {
    return static_cast<std::size_t>(word() % bound);
}

double Random::real(double limit) {
    const double unit = static_cast<double>(word() >> 11U) * 0x1p-53;
    return (2 * unit - 1) * limit;
}

Scene random_scene(Random& random, bool with_strike) {
    Scene scene;
    scene.id = random.coin() ? "" : person(random);
    scene.table = table_of_scene(random);
    scene.ball = {0.03 + random.real(0.01), 0.2 + random.real(0.1)};
    scene.gravity = 9.81 + random.real(0.1);
    scene.effects = effects(random);
    scene.solver = {fitting_solver(random, scene), 30 + 10 * static_cast<double>(random.below(10))};
    scene.limits = {random.real(300) + 301, 1 + number(random) % 100000};
    const std::size_t count = 1 + random.below(6);
    for (std::size_t i = 0; i < count; ++i) {
        SceneBall ball{i == 0 ? "cue" : std::to_string(i), state(random)};
        // Cells 0.3 m apart keep the balls on the table and from overlapping.
        const double cell = 0.3 * static_cast<double>(i);
        ball.state.r = {cell - 0.75 + random.real(0.1), random.real(0.8), 0};
        if (!scene.effects.airborne) ball.state.v.z = 0;
        if (random.coin()) ball.radius = 0.03 + random.real(0.01);
        if (random.coin()) ball.mass = positive(random, 0.3);
        scene.balls.push_back(ball);
    }
    if (with_strike) {
        scene.strike = Strike{BallIndex{static_cast<std::uint16_t>(random.below(count))},
                              direction(random),
                              positive(random, 30),
                              vec2(random, 0.7),
                              positive(random, 3),
                              positive(random, 1)};
    }
    return scene;
}

std::vector<Move> random_moves(Random& random) {
    Stroke stroke;
    stroke.direction = direction(random);
    if (random.coin()) {
        stroke.speed = positive(random, 20);
        stroke.offset = vec2(random, 1);
        stroke.elevation = positive(random, 10);
    }
    return {Shoot{stroke}, Place{vec2(random, kMaxPositionComponent)}, Concede{},
            Agree{any_of<Accord>(random)}, TimeOut{}};
}

std::vector<ClientMessage> random_client_messages(Random& random) {
    const auto stream = [&] { return any_of<Stream>(random); };
    std::vector<ClientBody> bodies{
        EntryCommand{CreateMatch{person(random), "end_game", stream(), settings(random)}},
        EntryCommand{JoinMatch{code(random), person(random), stream()}},
        EntryCommand{WatchMatch{code(random), random.coin() ? "" : person(random), stream()}},
        EntryCommand{Resume{code(random), token(random), stream()}},
        SeatCommand{TakeSeat{seat(random)}},
        SeatCommand{LeaveSeat{seat(random)}},
        SeatCommand{Leave{}},
    };
    for (const Move& move : random_moves(random))
        bodies.emplace_back(TurnCommand{MakeMove{seat(random), move}});
    Aim aim{seat(random), direction(random)};
    if (random.coin()) aim.cue = vec2(random, kMaxPositionComponent);
    bodies.emplace_back(TableTalk{aim});
    bodies.emplace_back(Ping{});
    std::vector<ClientMessage> messages;
    for (const ClientBody& body : bodies)
        messages.push_back({number(random) | 1U, body});
    return messages;
}

std::vector<ServerMessage> random_server_messages(Random& random) {
    return {
        Welcome{"poolhall 0.1.0", 1},
        Accepted{number(random) | 1U},
        Reject{number(random), any_of<RejectCode>(random), sentence(random)},
        joined(random),
        TableChanged{table(random)},
        AimChanged{seat(random), direction(random), vec2(random, 2)},
        shot_started(random),
        frame(random),
        shot_ended(random),
        Pong{number(random) | 1U},
        Closing{sentence(random)},
    };
}

}  // namespace poolhall::protocol::testing
