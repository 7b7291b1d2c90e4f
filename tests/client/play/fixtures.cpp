#include "tests/client/play/fixtures.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace poolhall::client {

using namespace protocol;

std::optional<TransportEvent> ScriptedTransport::next() {
    if (events.empty()) return std::nullopt;
    TransportEvent event = std::move(events.front());
    events.pop_front();
    return event;
}

std::vector<Move> ScriptedTransport::moves() const {
    std::vector<Move> moves;
    for (const MakeMove& made : sent_of<MakeMove, TurnCommand>())
        moves.push_back(made.move);
    return moves;
}

std::size_t ScriptedTransport::shots() const {
    const auto all = moves();
    return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](const Move& move) {
        return std::holds_alternative<Shoot>(move);
    }));
}

std::optional<std::string> TokensInMemory::claim(std::string_view server, std::string_view code) {
    const auto newest = std::find_if(entries_.rbegin(), entries_.rend(), [&](const Entry& entry) {
        return entry.server == server && entry.code == code;
    });
    return newest == entries_.rend() ? std::nullopt : std::optional(newest->token);
}

void TokensInMemory::keep(std::string_view server, std::string_view code, std::string_view token) {
    entries_.push_back({std::string(server), std::string(code), std::string(token)});
}

void TokensInMemory::forget(std::string_view token) {
    std::erase_if(entries_, [&](const Entry& entry) { return entry.token == token; });
}

Turn turn_of(const GameState& state, Vec2 direction) {
    const Move shot = completed(kEndGameRules.legal(state), Shoot{{.direction = direction}});
    return kEndGameRules.play(state, shot);
}

namespace {

void set_state(TableState& table, const GameState& state) {
    table.state = state;
    table.legal = kEndGameRules.legal(state);
    table.phase = state.over ? Phase::kOver : Phase::kAiming;
    if (!state.over) table.aim = table.legal.aim;
}

}  // namespace

TableState table_with_turn(Seat seat) {
    TableState table;
    table.match = "m1";
    table.code = "BCDFGH";
    table.game = kEndGameRules.name;
    table.seats = {SeatInfo{true, true, "Anna", false, 0}, SeatInfo{true, true, "Ben", false, 0}};
    set_state(table, kEndGameRules.new_game(seat));
    return table;
}

TableState new_table() {
    return table_with_turn(Seat{0});
}

namespace {

TableState table_after(const TableState& before, const Turn& turn) {
    TableState table = before;
    table.shot += 1;
    table.ruling = turn.ruling;
    set_state(table, turn.state);
    if (turn.ruling->winner) table.seats[turn.ruling->winner->value].wins += 1;
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
    const Turn turn = turn_of(table.state, direction);
    const Scene& scene = turn.shot->scene;
    const ShotTrace& trace = turn.shot->trace;
    const std::uint32_t shot = table.shot + 1;
    std::vector<ServerMessage> messages;
    messages.emplace_back(ShotStarted{shot, table.state.turn, scene, hash_of(scene), std::nullopt});
    std::size_t next_event = 0;
    const auto ticks = static_cast<std::uint32_t>(trace.sample_count() - 1);
    for (std::uint32_t tick = 1; tick <= ticks; ++tick) {
        messages.emplace_back(frame_at(trace, tick, shot, next_event));
    }
    ShotEnded end;
    end.shot = shot;
    end.ticks = ticks;
    end.duration = trace.duration;
    end.balls = trace.balls;
    end.hash = trace.hash;
    end.ruling = *turn.ruling;
    end.table = table_after(table, turn);
    messages.emplace_back(std::move(end));
    return messages;
}

Vec2 direction_with(Verdict verdict, double after) {
    const GameState game = kEndGameRules.new_game(Seat{0});
    for (int i = 0; i < 3600; ++i) {
        const double angle = i * 0.0017453292519943295;
        const Vec2 direction{std::cos(angle), std::sin(angle)};
        const Turn turn = turn_of(game, direction);
        const bool rolls_on = turn.shot->trace.duration >= turn.ruling->decided_at + after;
        if (turn.ruling->verdict == verdict && rolls_on) return direction;
    }
    throw std::runtime_error("no such direction");
}

}  // namespace poolhall::client
