#include "client/replay/report.hpp"

#include "protocol/replay/record_text.hpp"
#include "protocol/text.hpp"

#include <array>
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

std::string fixed(double number, int digits) {
    // Wide enough for the largest double; what is printed is far shorter.
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), "%.*f", digits, number);
    return text.data();
}

std::string direction_text(Vec2 direction) {
    const Vec2 unit = normalized(direction);
    return fixed(unit.x, 4) + "," + fixed(unit.y, 4);
}

/// "euler:30", or "event", which has no rate.
std::string solver_text(const SolverSpec& solver) {
    const std::string kind(name(solver.kind));
    if (solver.kind == SolverKind::kEvent) return kind;
    std::array<char, 32> rate{};
    std::snprintf(rate.data(), rate.size(), ":%g", solver.hz);
    return kind + rate.data();
}

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
        << std::setw(6) << "shots"
        << "  " << std::left << std::setw(20) << "created (UTC)" << std::setw(8) << "state"
        << "players\n";
    for (const auto& replay : replays) {
        out << std::left << std::setw(kIdWidth) << shown_id(replay.id) << ' ' << std::setw(10)
            << shown(replay.game) << std::right << std::setw(6) << replay.shots << "  " << std::left
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
         << (match.settings ? ", with physics of its own\n" : "\n");
}

void ReplayPrinter::print_record(const protocol::SeatRecord& seat) {
    names_.at(seat.seat.value) = seat.name;
    out_ << "seat " << int{seat.seat.value} << ": "
         << (seat.name.empty() ? "open" : shown(seat.name)) << '\n';
}

void ReplayPrinter::print_record(const protocol::GameRecord& game) {
    out_ << "game " << game.game_number << ", first shot by seat " << int{game.first.value} << '\n'
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
    out_ << std::right << std::setw(6) << shot.shot << "  " << std::setw(4) << int{shot.seat.value}
         << "  " << std::left << std::setw(kNameWidth) << name_of(shot.seat) << std::setw(16)
         << direction_text(strike.direction) << std::right << std::setw(8) << fixed(strike.speed, 3)
         << std::setw(9) << fixed(shot.duration, 3) << std::setw(8) << shot.event_count << "  "
         << std::left << std::setw(12) << name(shot.ruling.verdict) << std::setw(kSolverWidth)
         << solver_text(shot.scene.solver) << std::setw(kKernelWidth) << shown(shot.kernel)
         << to_hex(shot.final_hash) << '\n';
    if (shot.ruling.winner) out_ << "      won by " << name_of(*shot.ruling.winner) << '\n';
}

void ReplayPrinter::print_record(const protocol::EndRecord& end) {
    out_ << "end: " << shown(end.reason) << ", " << time_text(end.at_ms) << " UTC\n";
}

std::string ReplayPrinter::name_of(Seat seat) const {
    const std::string& name = names_.at(seat.value);
    return name.empty() ? "seat " + std::to_string(seat.value) : shown(name);
}

void print_report(std::ostream& out, const ShotReport& report) {
    const std::string shot = "shot " + std::to_string(report.shot) + ": ";
    if (report.divergences.empty()) out << shot << "ok " << to_hex(report.hash) << '\n';
    for (const std::string& divergence : report.divergences)
        out << shot << "DIVERGED " << divergence << '\n';
}

}  // namespace poolhall::client
