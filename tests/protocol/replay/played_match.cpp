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
Vec2 aim(const GameState& state, std::uint32_t shot) {
    const Vec2 straight = kEndGameRules.default_aim(state);
    const double off = 0.04 * static_cast<double>(shot % 7) - 0.1;
    return {straight.x - off * straight.y, straight.y + off * straight.x};
}

}  // namespace

std::vector<ReplayRecord> played_match(const std::string& id, std::uint32_t shots,
                                       const GameSettings& settings) {
    protocol::MatchRecord match{id, "end_game", "poolhall 0.1.0", kStart};
    if (settings != GameSettings{}) match.settings = settings;
    std::vector<ReplayRecord> records{match, protocol::SeatRecord{Seat{0}, "Ann"},
                                      protocol::SeatRecord{Seat{1}, "Bob"}};
    std::uint32_t game_number = 0;
    GameState state;
    state.over = true;
    for (std::uint32_t shot = 1; shot <= shots; ++shot) {
        if (state.over) {
            const Seat first{static_cast<std::uint8_t>(game_number % 2)};
            records.emplace_back(protocol::GameRecord{++game_number, first});
            state = new_game(kEndGameRules, first, settings);
            kEndGameRules.place_cue_ball(state, {end_game::kBaseLineX, 0.01 * game_number});
        }
        const ShotOutcome outcome = kEndGameRules.play(state, {aim(state, shot)});
        protocol::ShotRecord record = protocol::shot_record(outcome);
        record.shot = shot;
        record.game_number = game_number;
        record.at_ms = kStart + 10'000 * std::int64_t{shot};
        records.emplace_back(record);
        state = outcome.state;
    }
    records.emplace_back(protocol::EndRecord{"both players left", kStart + 10'000'000});
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
