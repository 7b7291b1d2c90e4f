#include "tests/protocol/replay/played_match.hpp"

#include "protocol/replay/line.hpp"
#include "protocol/replay/record_text.hpp"
#include "shared/game/end_game.hpp"

namespace poolhall::test {

using protocol::ReplayRecord;

namespace {

constexpr std::int64_t kStart = 1'700'000'000'000;  // ms

/// Aims past the 8-ball by an amount that changes from shot to shot, so that some shots hit and
/// some do not.
Shoot strike(const Legal& legal, std::uint32_t shot) {
    const double off = 0.04 * static_cast<double>(shot % 7) - 0.1;
    const Vec2 straight = legal.aim;
    return {Stroke{{straight.x - off * straight.y, straight.y + off * straight.x}, {}}};
}

/// Plays that many shots; `taken` hears of every step.
template <class Taken>
void play_shots(const MatchSettings& settings, std::uint32_t shots, const Taken& taken) {
    Match match({&kEndGameRules, Seat{0}, settings});
    std::int64_t now = kStart;
    const auto play = [&](Seat seat, const Move& move) {
        MatchStep step = match.play(seat, move, now);
        taken(step);
        match.commit(std::move(step), now);
    };
    for (std::uint32_t shot = 1; shot <= shots; ++shot) {
        now = kStart + 10'000 * std::int64_t{shot};
        if (match.now().game.over)
            for (const Seat seat : kSeats)
                play(seat, Agree{});
        if (match.now().legal.place)
            play(match.now().legal.seat,
                 Place{{end_game::kBaseLineX, 0.01 * match.now().game_number}});
        play(match.now().legal.seat, strike(match.now().legal, shot));
    }
}

protocol::ShotRecord shot_record(const MatchStep& step) {
    const ShotTaken& shot = *step.shot();
    const ShotTrace& trace = shot.simulated.trace;
    protocol::ShotRecord record;
    record.shot = shot.shot;
    record.game_number = step.after.game_number;
    record.seat = step.made.seat;
    record.scene = shot.simulated.scene;
    record.scene_hash = hash_of(record.scene);
    record.kernel = trace.kernel;
    record.final_hash = trace.hash;
    record.duration = trace.duration;
    record.event_count = static_cast<std::uint32_t>(trace.events.size());
    record.ruling = *step.ruling();
    record.at_ms = step.made.at_ms;
    for (const ShotEvent& event : trace.events)
        record.event_times.push_back(event.t);
    return record;
}

const GameBegan* begun_game(const MatchStep& step) {
    for (const MatchEvent& event : step.events)
        if (const auto* began = std::get_if<GameBegan>(&event)) return began;
    return nullptr;
}

std::vector<ReplayRecord> begin(const protocol::MatchRecord& match) {
    return {match, protocol::SeatRecord{Seat{0}, "Ann"}, protocol::SeatRecord{Seat{1}, "Bob"}};
}

protocol::EndRecord end() {
    return {"both players left", kStart + 10'000'000};
}

}  // namespace

protocol::MatchRecord match_record(const std::string& id) {
    protocol::MatchRecord match;
    match.match = id;
    match.game = "end_game";
    match.server = "poolhall 0.1.0";
    match.created_ms = kStart;
    match.first = Seat{0};
    return match;
}

protocol::MoveRecord some_move(std::int64_t at_ms) {
    const Match match({&kEndGameRules, Seat{0}});
    return protocol::move_record(match.play(Seat{0}, Place{{end_game::kBaseLineX, 0}}, at_ms));
}

std::vector<ReplayRecord> played_match(const std::string& id, std::uint32_t shots,
                                       const MatchSettings& settings) {
    protocol::MatchRecord match = match_record(id);
    if (settings != MatchSettings{}) match.settings = settings;
    auto records = begin(match);
    play_shots(settings, shots,
               [&](const MatchStep& step) { records.emplace_back(protocol::move_record(step)); });
    records.emplace_back(end());
    return records;
}

std::vector<ReplayRecord> played_match_v1(const std::string& id, std::uint32_t shots,
                                          const GameSettings& settings) {
    protocol::MatchRecord match = match_record(id);
    match.version = 1;
    match.first.reset();
    if (settings != GameSettings{}) match.settings = MatchSettings{settings};
    auto records = begin(match);
    if (shots > 0) records.emplace_back(protocol::GameRecord{1, Seat{0}});
    play_shots({settings}, shots, [&](const MatchStep& step) {
        if (const GameBegan* game = begun_game(step))
            records.emplace_back(protocol::GameRecord{game->game_number, game->first});
        if (step.shot() != nullptr) records.emplace_back(shot_record(step));
    });
    records.emplace_back(end());
    return records;
}

std::string replay_line(std::uint64_t n, const ReplayRecord& record) {
    const std::string text = protocol::to_text(n, record);
    return protocol::to_line({protocol::checksum_text(text), text});
}

std::string replay_file(const std::vector<ReplayRecord>& records) {
    std::string file;
    for (std::size_t i = 0; i < records.size(); ++i)
        file += replay_line(i + 1, records[i]);
    return file;
}

}  // namespace poolhall::test
