#include "client/replay/report.hpp"

#include "protocol/intake/text_width.hpp"
#include "protocol/replay/record_text.hpp"
#include "protocol/text.hpp"
#include "shared/analysis/effect_use.hpp"
#include "shared/physics/simulate.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <iomanip>

namespace poolhall::client {

namespace {

using protocol::shown;

constexpr int kIdWidth = 24;
constexpr int kNameWidth = 16;
constexpr int kSolverWidth = 14;
constexpr int kKernelWidth = 26;

/// An id is shown whole where it is one, so that it can be copied.
std::string shown_id(const std::string& id) {
    return protocol::is_match_id(id) ? id : shown(id);
}

std::string players(const std::array<std::string, kSeatCount>& names) {
    const auto name = [](const std::string& text) {
        return text.empty() ? std::string("-") : shown(text);
    };
    return name(names[0]) + " / " + name(names[1]);
}

std::string score(const PerSeat<std::uint32_t>& wins) {
    return std::to_string(wins[0]) + ":" + std::to_string(wins[1]);
}

std::string fixed(double number, int digits) {
    // Wide enough for the largest double; what is printed is far shorter.
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), "%.*f", digits, number);
    return text.data();
}

/// With blanks at its end, for a column of so many places; std::setw counts bytes.
std::string padded(const std::string& text, std::size_t places) {
    const std::size_t width = protocol::text_width(text);
    return text + std::string(width < places ? places - width : 0, ' ');
}

std::string direction_text(Vec2 direction) {
    const Vec2 unit = normalized(direction);
    return fixed(unit.x, 4) + "," + fixed(unit.y, 4);
}

/// "euler:30", or "event", which has no rate.
std::string solver_text(const SolverSpec& solver) {
    const std::string kind(name(solver.kind));
    if (!has_ticks(solver.kind)) return kind;
    std::array<char, 32> rate{};
    std::snprintf(rate.data(), rate.size(), ":%g", solver.hz);
    return kind + rate.data();
}

/// A row of the table of shots; both versions have these columns.
struct ShotRow {
    std::uint32_t shot = 0;
    Seat seat;
    std::string player;
    Vec2 direction;
    double speed = 0;     ///< m/s
    double duration = 0;  ///< s
    std::uint32_t events = 0;
    std::string ruling;
    SolverSpec solver;
    std::string kernel;
    std::uint64_t hash = 0;
};

void print_row(std::ostream& out, const ShotRow& row) {
    out << std::right << std::setw(6) << row.shot << "  " << std::setw(4) << int{row.seat.value}
        << "  " << std::left << padded(row.player, kNameWidth) << std::setw(16)
        << direction_text(row.direction) << std::right << std::setw(8) << fixed(row.speed, 3)
        << std::setw(9) << fixed(row.duration, 3) << std::setw(8) << row.events << "  " << std::left
        << std::setw(12) << row.ruling << std::setw(kSolverWidth) << solver_text(row.solver)
        << std::setw(kKernelWidth) << shown(row.kernel) << to_hex(row.hash) << '\n';
}

/// How the cue was held, where that is told: "offset 0.30 right, 0.20 down; elevation 0.100".
std::string cue_text(const Stroke& stroke) {
    std::string text;
    if (stroke.offset != Vec2{}) {
        const auto [right, up] = stroke.offset;
        text = "offset " + fixed(std::abs(right), 2) + (right < 0 ? " left, " : " right, ") +
               fixed(std::abs(up), 2) + (up < 0 ? " down" : " up");
    }
    if (stroke.elevation == 0) return text;
    return text + (text.empty() ? "" : "; ") + "elevation " + fixed(stroke.elevation, 3);
}

std::string verdict_text(const std::optional<Ruling>& ruling) {
    return ruling ? std::string(name(ruling->verdict)) : "-";
}

/// What the players have agreed on besides the physics: "race to 3, the winner breaks, 30 s a
/// shot".
void print_settings(std::ostream& out, const MatchSettings& settings) {
    std::string text;
    if (settings.race_to > 0) text += ", race to " + std::to_string(settings.race_to);
    if (settings.breaks != BreakOrder::kAlternate)
        text += ", the " + std::string(name(settings.breaks)) + " breaks";
    if (settings.shot_clock_s) text += ", " + std::to_string(*settings.shot_clock_s) + " s a shot";
    if (settings.turns == Turns::kSolo) text += ", seat 0 alone";
    if (!text.empty()) out << "settings: " << text.substr(2) << '\n';
}

struct MoveWords {
    std::string operator()(const Shoot&) const { return "shoots"; }

    std::string operator()(const Place& place) const {
        return "places the cue ball at " + fixed(place.position.x, 4) + "," +
               fixed(place.position.y, 4) + " m";
    }

    std::string operator()(const Concede&) const { return "concedes the game"; }

    std::string operator()(const Agree& agree) const {
        return "agrees to a " + std::string(name(agree.what));
    }

    std::string operator()(const TimeOut&) const { return "has run out of time"; }
};

}  // namespace

std::string time_text(std::int64_t unix_ms) {
    const auto seconds = static_cast<std::time_t>(unix_ms / 1000);
    std::tm time{};
    std::array<char, 64> text{};
    if (gmtime_r(&seconds, &time) == nullptr) return "?";
    std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &time);
    return text.data();
}

void print_list(std::ostream& out, const std::vector<protocol::ReplaySummary>& replays) {
    out << std::left << std::setw(kIdWidth) << "id" << ' ' << std::setw(10) << "game" << std::right
        << std::setw(6) << "shots" << std::setw(7) << "games" << std::setw(9) << "score"
        << "  " << std::left << std::setw(20) << "created (UTC)" << std::setw(8) << "state"
        << "players\n";
    for (const auto& replay : replays) {
        out << std::left << std::setw(kIdWidth) << shown_id(replay.id) << ' ' << std::setw(10)
            << shown(replay.game) << std::right << std::setw(6) << replay.shots << std::setw(7)
            << replay.games << std::setw(9) << score(replay.wins) << "  " << std::left
            << std::setw(20) << time_text(replay.created_ms) << std::setw(8)
            << (replay.closed_ms ? "closed" : "open") << players(replay.names) << '\n';
    }
}

void ReplayPrinter::print(const protocol::ReplayRecord& record) {
    std::visit([this](const auto& alternative) { print_record(alternative); }, record);
}

void ReplayPrinter::print_record(const protocol::MatchRecord& match) {
    out_ << "match " << shown_id(match.match) << ", " << shown(match.game) << ", created "
         << time_text(match.created_ms) << " UTC by " << shown(match.server)
         << (match.settings && match.settings->game != GameSettings{} ? ", with physics of its own"
                                                                      : "")
         << '\n';
    if (match.settings) print_settings(out_, *match.settings);
    if (match.first) print_game(1, *match.first);
}

void ReplayPrinter::print_record(const protocol::SeatRecord& seat) {
    names_.at(seat.seat.value) = seat.name;
    out_ << "seat " << int{seat.seat.value} << ": "
         << (seat.name.empty() ? "open" : shown(seat.name)) << '\n';
}

void ReplayPrinter::print_record(const protocol::GameRecord& game) {
    print_game(game.game_number, game.first);
}

void ReplayPrinter::print_game(std::uint32_t number, Seat first) {
    games_ = number;
    out_ << "game " << number << ", first shot by seat " << int{first.value} << '\n'
         << std::right << std::setw(6) << "shot"
         << "  seat  " << std::left << std::setw(kNameWidth) << "player" << std::setw(16)
         << "direction" << std::right << std::setw(8) << "m/s" << std::setw(9) << "s"
         << std::setw(8) << "events"
         << "  " << std::left << std::setw(12) << "ruling" << std::setw(kSolverWidth) << "solver"
         << std::setw(kKernelWidth) << "kernel"
         << "hash\n";
}

void ReplayPrinter::print_record(const protocol::ShotRecord& shot) {
    const Strike strike = shot.scene.strike.value_or(Strike{});
    print_row(out_, {shot.shot, shot.seat, name_of(shot.seat), strike.direction, strike.speed,
                     shot.duration, shot.event_count, verdict_text(shot.ruling), shot.scene.solver,
                     shot.kernel, shot.final_hash});
    print_winner(shot.ruling);
}

void ReplayPrinter::print_record(const protocol::MoveRecord& move) {
    const auto* shoot = std::get_if<Shoot>(&move.move);
    if (shoot == nullptr || !move.shot) {
        print_move(move, std::visit(MoveWords{}, move.move));
    } else {
        const protocol::ShotEvidence& shot = *move.shot;
        const Stroke& stroke = shoot->strike;
        print_row(out_,
                  {shot.shot, move.seat, name_of(move.seat), stroke.direction,
                   stroke.speed.value_or(0), shot.duration, shot.event_count,
                   verdict_text(move.ruling), move.state.scene.solver, shot.kernel, shot.trace});
        if (const std::string cue = cue_text(stroke); !cue.empty()) out_ << "      " << cue << '\n';
        if (shot.effects) out_ << "      " << analysis::in_words(*shot.effects) << '\n';
    }
    print_winner(move.ruling);
    // The second seat's consent brings the next game about.
    if (std::holds_alternative<Agree>(move.move) && !move.state.over)
        print_game(games_ + 1, move.state.turn);
}

/// A move that is no shot, in words where a shot has its columns; the hash is the state's.
void ReplayPrinter::print_move(const protocol::MoveRecord& move, const std::string& words) {
    out_ << std::right << std::setw(6) << "-"
         << "  " << std::setw(4) << int{move.seat.value} << "  " << std::left
         << padded(name_of(move.seat), kNameWidth) << std::setw(43) << words << std::setw(12)
         << verdict_text(move.ruling) << std::setw(kSolverWidth) << "-" << std::setw(kKernelWidth)
         << "state" << to_hex(move.state_hash) << '\n';
}

void ReplayPrinter::print_winner(const std::optional<Ruling>& ruling) {
    if (ruling && ruling->winner) out_ << "      won by " << name_of(*ruling->winner) << '\n';
}

void ReplayPrinter::print_record(const protocol::EndRecord& end) {
    out_ << "end: " << shown(end.reason) << ", " << time_text(end.at_ms) << " UTC\n";
}

std::string ReplayPrinter::name_of(Seat seat) const {
    const std::string& name = names_.at(seat.value);
    return name.empty() ? "seat " + std::to_string(seat.value) : shown(name);
}

void print_followed(std::ostream& out, const protocol::Followed& followed) {
    const auto& [deviations, remarks] = followed.found;
    for (const std::string& deviation : deviations)
        out << followed.subject << ": DIVERGED " << deviation << '\n';
    std::string text;
    if (deviations.empty() && followed.shot && followed.shot->as_recorded)
        text = "ok " + to_hex(followed.shot->hash);
    for (const std::string& remark : remarks)
        text += (text.empty() ? "" : ", ") + remark;
    if (!text.empty()) out << followed.subject << ": " << text << '\n';
}

}  // namespace poolhall::client
