#include "protocol/replay/record_text.hpp"

#include "protocol/replay/line.hpp"
#include "tests/protocol/replay/played_match.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace poolhall::protocol {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kShots = 12;

/// A shot of either version.
Json shot_json(int version = kReplayVersion) {
    if (version == 1) return Json::parse(to_text(5, test::played_match_v1("m1", 1).at(4)));
    return Json::parse(to_text(5, test::played_match("m1", 1).at(4)));
}

/// The pointer of the error in reading `json`; "ok" if there is none.
std::string fault_of(const Json& json) {
    const auto record = record_from_text(json.dump());
    return record ? "ok" : record.error().pointer;
}

TEST(RecordText, ReadsBackToWhatWasWritten) {
    for (const auto& records :
         {test::played_match("m1", kShots), test::played_match_v1("m1", kShots)}) {
        std::uint64_t n = 0;
        for (const ReplayRecord& record : records) {
            const std::string text = to_text(++n, record);
            const auto read = record_from_text(text);
            ASSERT_TRUE(read) << read.error().pointer << ": " << read.error().reason;
            EXPECT_EQ(read->n, n);
            EXPECT_EQ(read->record.index(), record.index());
            EXPECT_EQ(to_text(n, read->record), text);
        }
    }
}

TEST(RecordText, KeepsEveryBitOfAMove) {
    for (const ReplayRecord& record : test::played_match("m1", kShots)) {
        const auto* move = std::get_if<MoveRecord>(&record);
        if (move == nullptr) continue;
        const auto read = record_from_text(to_text(1, *move));
        ASSERT_TRUE(read);
        const auto& copy = std::get<MoveRecord>(read->record);
        EXPECT_EQ(copy.move, move->move);
        EXPECT_EQ(copy.state, move->state);
        EXPECT_EQ(hash_of(copy.state), move->state_hash);
        EXPECT_EQ(copy.ruling, move->ruling);
        ASSERT_EQ(copy.shot.has_value(), move->shot.has_value());
        if (!copy.shot) continue;
        EXPECT_EQ(copy.shot->duration, move->shot->duration);
        EXPECT_EQ(copy.shot->event_times, move->shot->event_times);
    }
}

TEST(RecordText, KeepsEveryBitOfAShotOfVersion1) {
    for (const ReplayRecord& record : test::played_match_v1("m1", kShots)) {
        const auto* shot = std::get_if<ShotRecord>(&record);
        if (shot == nullptr) continue;
        const auto read = record_from_text(to_text(1, *shot));
        ASSERT_TRUE(read);
        const auto& copy = std::get<ShotRecord>(read->record);
        EXPECT_EQ(copy.scene, shot->scene);
        EXPECT_EQ(hash_of(copy.scene), shot->scene_hash);
        EXPECT_EQ(copy.ruling, shot->ruling);
        EXPECT_EQ(copy.duration, shot->duration);
        EXPECT_EQ(copy.event_times, shot->event_times);
    }
}

TEST(RecordText, OfVersion1IsByteForByteWhatItAlwaysWas) {
    const std::string file = test::replay_file(test::played_match_v1("m1", 100));
    EXPECT_EQ(checksum_text(file), "8a01684824b297e5");
}

TEST(RecordText, IsOneLine) {
    EXPECT_EQ(to_text(1, SeatRecord{Seat{1}, "a\nb"}).find('\n'), std::string::npos);
}

TEST(RecordText, EveryMissingFieldIsNamed) {
    for (const int version : {1, 2}) {
        const Json whole = shot_json(version);
        ASSERT_EQ(fault_of(whole), "ok");
        for (const auto& [key, unused] : whole.items()) {
            Json json = whole;
            json.erase(key);
            // A state may be without a ruling: the same seat goes on.
            EXPECT_EQ(fault_of(json), version == 2 && key == "ruling" ? "ok" : "/" + key);
        }
    }
}

TEST(RecordText, EveryFieldOfAnotherTypeIsNamed) {
    for (const int version : {1, 2}) {
        const Json whole = shot_json(version);
        for (const auto& [key, unused] : whole.items()) {
            for (const Json& wrong :
                 {Json(nullptr), Json(true), Json(-1), Json::array({Json::object()})}) {
                Json json = whole;
                json[key] = wrong;
                EXPECT_EQ(fault_of(json).substr(0, key.size() + 1), "/" + key) << wrong;
            }
        }
    }
}

TEST(RecordText, UnknownFieldsAndKindsAreRefused) {
    Json json = shot_json();
    json["spin"] = 1;
    EXPECT_EQ(fault_of(json), "/spin");
    json = shot_json();
    json["kind"] = "comment";
    EXPECT_EQ(fault_of(json), "/kind");
    json = shot_json();
    json["move"]["type"] = "blow";
    EXPECT_EQ(fault_of(json), "/move/type");
    json = shot_json();
    json["state"]["scene"]["effects"]["wind"] = Json::object();
    EXPECT_EQ(fault_of(json), "/state/scene/effects/wind");
    json = shot_json(1);
    json["scene"]["effects"]["wind"] = Json::object();
    EXPECT_EQ(fault_of(json), "/scene/effects/wind");
}

TEST(RecordText, ASceneThatCannotBeSimulatedIsRefused) {
    Json json = shot_json();
    Json& balls = json["state"]["scene"]["balls"];
    balls[1]["r"] = balls[0]["r"];
    EXPECT_EQ(fault_of(json).substr(0, 18), "/state/scene/balls");
    json = shot_json(1);
    json["scene"]["balls"][1]["r"] = json["scene"]["balls"][0]["r"];
    EXPECT_EQ(fault_of(json).substr(0, 12), "/scene/balls");
    json = shot_json(1);
    json["scene"].erase("strike");
    EXPECT_EQ(fault_of(json), "/scene/strike");
}

TEST(RecordText, OnlyAShotHasTheEvidenceOfOne) {
    Json json = Json::parse(to_text(1, test::some_move(0)));
    ASSERT_EQ(fault_of(json), "ok");
    json["shot"] = shot_json()["shot"];
    EXPECT_EQ(fault_of(json), "/shot");
}

TEST(RecordText, TakesAnyEditionKernelAndSolver) {
    Json json = shot_json();
    for (const std::uint32_t edition : {0U, 1U, 4294967295U}) {
        json["shot"]["edition"] = edition;
        EXPECT_EQ(fault_of(json), "ok");
    }
    json["shot"]["kernel"] = "warp";
    json["shot"]["solver"] = "leapfrog";
    EXPECT_EQ(fault_of(json), "ok");
}

TEST(RecordText, AnUnknownVersionIsSaidWhateverElseIsThere) {
    Json json = Json::parse(to_text(1, test::match_record("m1")));
    json["format"] = "poolhall.replay/1";
    EXPECT_EQ(fault_of(json), "/first") << "version 1 has none";
    for (const Json& format : {Json("poolhall.replay/3"), Json("poolhall.replay/02"), Json(2)}) {
        json["format"] = format;
        json["kind"] = "overture";
        json.erase("n");
        const auto record = record_from_text(json.dump());
        ASSERT_FALSE(record);
        EXPECT_EQ(record.error().fault, RecordFault::kUnknownVersion) << format;
    }
    json = Json::parse(to_text(1, test::match_record("m1")));
    json.erase("format");
    EXPECT_EQ(fault_of(json), "/format");
}

/// What counts as a name has changed since, and may again.
TEST(RecordText, KeepsNamesThatWereTakenOnce) {
    for (const std::string name : {"\u3164", " a ", "\u0301"})
        EXPECT_EQ(fault_of(Json::parse(to_text(2, SeatRecord{Seat{1}, name}))), "ok") << name;
}

TEST(RecordText, KeepsTheSettingsOfAMatch) {
    MatchRecord match = test::match_record("m1");
    EXPECT_EQ(to_text(1, match).find("settings"), std::string::npos) << "as before there were any";
    match.settings.emplace().game.solver = SolverSpec{SolverKind::kEvent, 30};
    match.settings->game.effects.emplace().rolling = RollingSpec{0.01};
    const auto read = record_from_text(to_text(1, match));
    ASSERT_TRUE(read) << read.error().pointer;
    EXPECT_EQ(std::get<MatchRecord>(read->record).settings, match.settings);

    Json json = Json::parse(to_text(1, match));
    json["settings"]["effects"]["wind"] = Json::object();
    EXPECT_EQ(fault_of(json), "/settings/effects/wind");
    json["settings"] = nullptr;
    EXPECT_EQ(fault_of(json), "/settings");
    json.erase("settings");
    EXPECT_EQ(fault_of(json), "ok");
}

TEST(RecordText, AMatchIdIsNoPath) {
    for (const std::string id : {"", "..", "../m1", "a/b", "a b", "a.b"}) {
        EXPECT_FALSE(is_match_id(id)) << id;
        EXPECT_EQ(fault_of(Json::parse(to_text(1, test::match_record(id)))), "/match");
    }
    EXPECT_TRUE(is_match_id("Az09_-"));
    EXPECT_FALSE(is_match_id(std::string(65, 'a')));
}

TEST(RecordText, EventTimesAreAllThereOrNone) {
    Json json = shot_json(1);
    json["event_times"] = Json::array();
    EXPECT_EQ(fault_of(json), "ok");
    json["event_times"] = Json::array({0.5});
    EXPECT_EQ(fault_of(json), "/event_times");
    json = shot_json();
    json["shot"]["event_times"] = Json::array();
    EXPECT_EQ(fault_of(json), "ok");
    json["shot"]["event_times"] = Json::array({0.5});
    EXPECT_EQ(fault_of(json), "/shot/event_times");
}

TEST(RecordText, WhatIsNotJsonIsSaidToBeNone) {
    for (const std::string text : {"", "{", "[1", "nul", "{}{}"}) {
        const auto record = record_from_text(text);
        ASSERT_FALSE(record) << text;
        EXPECT_EQ(record.error().fault, RecordFault::kNotJson) << text;
    }
    EXPECT_EQ(record_from_text("[]").error().fault, RecordFault::kBadField);
    const auto number = record_from_text("{\"n\":1e999}");
    ASSERT_FALSE(number);
    EXPECT_EQ(number.error().fault, RecordFault::kBadField);
    EXPECT_EQ(number.error().pointer, "/n");
}

}  // namespace
}  // namespace poolhall::protocol
