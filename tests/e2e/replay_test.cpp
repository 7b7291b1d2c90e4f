#include "protocol/replay/line.hpp"
#include "protocol/replay/record_text.hpp"
#include "shared/game/end_game.hpp"
#include "tests/e2e/server_process.hpp"
#include "tests/e2e/table.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <optional>
#include <sstream>
#include <variant>

// What was played, as poolhall-replay and /api/replays tell it.
namespace poolhall::e2e {
namespace {

using namespace protocol;

std::string read(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The export with shot `number` aimed elsewhere, and checksums that hide it.
std::string with_shot_changed(const std::string& exported, std::uint32_t number) {
    std::istringstream lines(exported);
    std::string changed;
    for (std::string line; std::getline(lines, line);) {
        auto record = record_from_text(split_line(line).value().record);
        MoveRecord* made = std::get_if<MoveRecord>(&record.value().record);
        if (made != nullptr && made->shot && made->shot->shot == number)
            std::get<Shoot>(made->move).strike.direction.y += 0.001;
        const std::string text = to_text(record.value().n, record.value().record);
        changed += to_line({checksum_text(text), text});
    }
    return changed;
}

/// A match of three shots: a pass and a win, then a scratch in the rematch.
class Replay : public testing::Test {
  protected:
    void SetUp() override {
        shots.push_back(duel.play(Verdict::kTurnPasses));
        shots.push_back(duel.play(Verdict::kWon));
        duel.ann.request(rematch_by(Seat{0}));
        duel.bob.request(rematch_by(Seat{1}));
        duel.game = kEndGameRules.new_game(opponent(shots[0].ruling.shooter));
        shots.push_back(duel.play(Verdict::kScratch));
    }

    Finished tool(const std::string& command, std::vector<std::string> arguments = {}) {
        std::vector<std::string> words{POOLHALL_REPLAY, command};
        if (arguments.empty() || arguments.front() != "--file")
            words.insert(words.end(), {"--data", data.path()});
        words.insert(words.end(), arguments.begin(), arguments.end());
        return run(words);
    }

    Finished verify(const std::string& text) {
        std::ofstream(file, std::ios::binary) << text;
        return tool("verify", {"--file", file});
    }

    TemporaryFolder data;
    TemporaryFolder elsewhere;
    std::filesystem::path file = elsewhere.path() / "match.jsonl";
    ServerProcess server{data.path()};
    Duel duel{server.port()};
    std::string id = duel.ann_joined.table.match;
    std::vector<PlayedShot> shots;
};

TEST_F(Replay, IsListedShownVerifiedAndExported) {
    const Finished list = tool("list");
    EXPECT_EQ(list.status, 0) << list.err;
    EXPECT_NE(list.out.find(id), std::string::npos) << list.out;

    const Finished shown = tool("show", {id});
    EXPECT_EQ(shown.status, 0) << shown.err;
    const Finished verified = tool("verify", {id});
    EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
    for (const PlayedShot& shot : shots) {
        EXPECT_NE(shown.out.find(to_hex(shot.trace.hash)), std::string::npos) << shown.out;
        EXPECT_NE(verified.out.find(to_hex(shot.trace.hash)), std::string::npos) << verified.out;
    }

    EXPECT_EQ(tool("export", {id, file}).status, 0);
    const HttpAnswer answer = http_get(server.port(), "/api/replays/" + id);
    EXPECT_EQ(answer.status, 200);
    EXPECT_EQ(answer.body, read(file));
    EXPECT_EQ(tool("verify", {"--file", file}).status, 0);
    EXPECT_NE(http_get(server.port(), "/api/replays").body.find(id), std::string::npos);
    EXPECT_EQ(tool("show", {"0123456789abcdef"}).status, 2);
}

TEST_F(Replay, IsVerifiedToTheFirstShotThatDivergesAndReadToTheFirstDamage) {
    const std::string exported = http_get(server.port(), "/api/replays/" + id).body;
    const Finished changed = verify(with_shot_changed(exported, 2));
    EXPECT_EQ(changed.status, 1) << changed.out << changed.err;
    EXPECT_NE(changed.out.find("shot 1: ok"), std::string::npos) << changed.out;
    EXPECT_NE(changed.out.find("shot 2: DIVERGED"), std::string::npos) << changed.out;
    EXPECT_NE(changed.out.find("the first is shot 2"), std::string::npos) << changed.out;
    EXPECT_EQ(verify(exported).status, 0) << "unchanged, the same file is fine";

    std::string flipped = exported;
    flipped[exported.rfind("direction")] ^= 1;
    const Finished damaged = verify(flipped);
    EXPECT_EQ(damaged.status, 2) << damaged.out;
    EXPECT_NE(damaged.out.find("shot 2: ok"), std::string::npos) << damaged.out;
    EXPECT_NE(damaged.err.find("checksum"), std::string::npos) << damaged.err;

    const Finished torn = verify(exported.substr(0, exported.size() - 10));
    EXPECT_EQ(torn.status, 2) << torn.out;
    EXPECT_NE(torn.out.find("shot 2: ok"), std::string::npos) << torn.out;
    EXPECT_NE(torn.err.find("line"), std::string::npos) << torn.err;
}

}  // namespace
}  // namespace poolhall::e2e
