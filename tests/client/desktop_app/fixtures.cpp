#include "tests/client/desktop_app/fixtures.hpp"

#include "client/play/match.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace poolhall::client {

using namespace protocol;

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "poolhall-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path = name;
}

TableState new_table() {
    const GameState game = kEndGameRules.new_game(Seat{0});
    TableState table;
    table.match = "m1";
    table.code = "BCDFGH";
    table.game = kEndGameRules.name;
    table.phase = Phase::kAiming;
    table.may_place = true;
    table.seats = {SeatInfo{true, true, "Anna", false, 0}, SeatInfo{true, true, "Ben", false, 0}};
    table.scene = game.scene;
    table.cue_ball = game.cue_ball;
    table.aim = kEndGameRules.default_aim(game);
    return table;
}

namespace {

TableState table_after(const TableState& before, const ShotOutcome& outcome) {
    TableState table = before;
    table.shot += 1;
    table.scene = outcome.state.scene;
    table.turn = outcome.state.turn;
    table.may_place = false;
    table.phase = outcome.state.over ? Phase::kOver : Phase::kAiming;
    table.ruling = outcome.ruling;
    if (outcome.ruling.winner) table.seats[outcome.ruling.winner->value].wins += 1;
    if (!outcome.state.over) table.aim = kEndGameRules.default_aim(outcome.state);
    return table;
}

Frame frame_at(const ShotTrace& trace, std::uint32_t tick, std::uint32_t shot,
               std::size_t& next_event) {
    Frame frame;
    frame.shot = shot;
    frame.tick = tick;
    for (std::uint16_t i = 0; i < trace.balls.size(); ++i) {
        if (trace.sample(tick, i) != trace.sample(tick - 1, i)) {
            frame.balls.push_back({BallIndex{i}, xy(trace.sample(tick, i))});
        }
    }
    while (next_event < trace.events.size() && trace.events[next_event].t <= tick / 30.0) {
        frame.events.push_back(trace.events[next_event++]);
    }
    return frame;
}

}  // namespace

std::vector<ServerMessage> messages_of_shot(const TableState& table, Vec2 direction) {
    const ShotOutcome outcome = kEndGameRules.play(game_state_of(table), {direction});
    const std::uint32_t shot = table.shot + 1;
    std::vector<ServerMessage> messages;
    messages.emplace_back(
        ShotStarted{shot, table.turn, outcome.scene, hash_of(outcome.scene), std::nullopt});
    std::size_t next_event = 0;
    const auto ticks = static_cast<std::uint32_t>(outcome.trace.sample_count() - 1);
    for (std::uint32_t tick = 1; tick <= ticks; ++tick) {
        messages.emplace_back(frame_at(outcome.trace, tick, shot, next_event));
    }
    ShotEnded end;
    end.shot = shot;
    end.ticks = ticks;
    end.duration = outcome.trace.duration;
    end.balls = outcome.trace.balls;
    end.hash = outcome.trace.hash;
    end.ruling = outcome.ruling;
    end.table = table_after(table, outcome);
    messages.emplace_back(std::move(end));
    return messages;
}

Vec2 direction_with(Verdict verdict, double after) {
    const GameState game = kEndGameRules.new_game(Seat{0});
    for (int i = 0; i < 3600; ++i) {
        const double angle = i * 0.0017453292519943295;
        const Vec2 direction{std::cos(angle), std::sin(angle)};
        const ShotOutcome outcome = kEndGameRules.play(game, {direction});
        const bool rolls_on = outcome.trace.duration >= outcome.ruling.decided_at + after;
        if (outcome.ruling.verdict == verdict && rolls_on) return direction;
    }
    throw std::runtime_error("no such direction");
}

}  // namespace poolhall::client
