#include "protocol/codec/scene_json.hpp"
#include "server/room/rebuild.hpp"
#include "tests/server/store/store_fixture.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

// Open matches that a server of version 1 left (tests/golden/replay_v1) go on.
namespace poolhall::server {
namespace {

using namespace poolhall::test;
using Json = nlohmann::ordered_json;

const std::filesystem::path kSamples = POOLHALL_SOURCE_DIR "/tests/golden/replay_v1";

/// Between places of the same ball, m.
double largest_distance(const Scene& a, const Scene& b) {
    double largest = a.balls.size() == b.balls.size() ? 0 : kInfinity;
    for (std::size_t i = 0; i < a.balls.size() && i < b.balls.size(); ++i)
        largest = std::max(largest, length(xy(a.balls[i].state.r) - xy(b.balls[i].state.r)));
    return largest;
}

class RebuildOfVersion1 : public testing::Test {
  protected:
    void SetUp() override {
        std::filesystem::copy_file(kSamples / "poolhall.sqlite",
                                   folder_.path() / "poolhall.sqlite");
        store_ = open_store(folder_.path());
    }

    /// The open matches by id, as a server that starts brings them back.
    [[nodiscard]] std::map<std::string, Table> tables() const {
        std::map<std::string, Table> tables;
        const auto open = store_->load_open_matches();
        EXPECT_TRUE(open && open->damaged.empty());
        for (const StoredMatch& stored : open->matches) {
            auto table = rebuild(stored);
            if (table)
                tables.emplace(stored.id, std::move(*table));
            else
                ADD_FAILURE() << stored.id << ": " << table.error();
        }
        return tables;
    }

    [[nodiscard]] ReplayStore& store() { return *store_; }

  private:
    TemporaryFolder folder_;
    std::unique_ptr<ReplayStore> store_;
};

TEST_F(RebuildOfVersion1, StandsWhereAServerOfThatVersionHadIt) {
    const auto all = tables();
    const Json resumed = Json::parse(read_file(kSamples / "resumed.json"));
    EXPECT_EQ(all.size(), resumed.size());
    for (const auto& [name, joined] : resumed.items()) {
        const Json& then = joined.at("table");
        const Table& table = all.at(then.at("match"));
        const Position& now = table.match.now();
        EXPECT_EQ(table.code, then.at("code"));
        EXPECT_EQ(now.game_number, then.at("game_number")) << name;
        EXPECT_EQ(now.shots, then.at("shot")) << name;
        EXPECT_EQ(now.game.turn.value, then.at("turn")) << name;
        EXPECT_EQ(now.game.over, then.at("phase") == "over") << name;
        EXPECT_EQ(now.legal.place.has_value(), then.at("may_place").get<bool>()) << name;
        EXPECT_EQ(now.ruling.has_value(), then.contains("ruling")) << name;
        const Scene scene = *protocol::scene_from_json(then.at("scene"));
        if (name == "open_settings") {
            EXPECT_LT(largest_distance(now.game.scene, scene), 1e-3)
                << "by Mathavan's rail, whose last digits are others since edition 2";
        } else {
            EXPECT_EQ(now.game.scene, scene) << name;
        }
        for (const Seat seat : kSeats) {
            const Json& held = then.at("seats").at(seat.value);
            const auto& holder = table.roster.holder(seat);
            EXPECT_EQ(holder ? holder->name : "", held.at("name")) << name;
            EXPECT_EQ(now.wins[seat.value], held.at("wins")) << name;
            EXPECT_FALSE(now.consents[seat.value]) << name;
        }
    }
}

/// Ends the game that stands, if need be, and plays some of the next one.
void play_on(ReplayStore& store, const Table& table) {
    Match match = table.match;
    const auto play = [&](Seat seat, const Move& move) {
        MatchStep step = match.play(seat, move, 0);
        EXPECT_EQ(done(store, AppendMoveJob{table.id, protocol::move_record(step)}), "ok");
        match.commit(std::move(step), 0);
    };
    if (!match.now().game.over) play(match.now().legal.seat, Shoot{Stroke{{-1, 0.02}, {}}});
    if (!match.now().game.over) play(Seat{1}, Concede{});
    for (const Seat seat : kSeats)
        play(seat, Agree{});
    play(match.now().legal.seat, Place{match.now().legal.place->low});
    play(match.now().legal.seat, Shoot{Stroke{{-1, 0.02}, {}}});
}

TEST_F(RebuildOfVersion1, GoesOnWithMovesAndIsBroughtBackWithThem) {
    const auto before = tables();
    for (const auto& [id, table] : before)
        play_on(store(), table);
    const auto after = tables();
    ASSERT_EQ(after.size(), before.size());
    for (const auto& [id, table] : after)
        EXPECT_EQ(table.match.now().game_number, before.at(id).match.now().game_number + 1) << id;
}

}  // namespace
}  // namespace poolhall::server
