#include "protocol/replay/record_text.hpp"

#include "protocol/replay/line.hpp"
#include "tests/protocol/replay/played_match.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace poolhall::protocol {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kShots = 12;

Json shot_json() {
    const auto records = test::played_match("m1", 1);
    return Json::parse(to_text(5, records.at(4)));
}

/// The pointer of the error in reading `json`; "ok" if there is none.
std::string fault_of(const Json& json) {
    const auto record = record_from_text(json.dump());
    return record ? "ok" : record.error().pointer;
}

TEST(RecordText, ReadsBackToWhatWasWritten) {
    std::uint64_t n = 0;
    for (const ReplayRecord& record : test::played_match("m1", kShots)) {
        const std::string text = to_text(++n, record);
        const auto read = record_from_text(text);
        ASSERT_TRUE(read) << read.error().pointer << ": " << read.error().reason;
        EXPECT_EQ(read->n, n);
        EXPECT_EQ(read->record.index(), record.index());
        EXPECT_EQ(to_text(n, read->record), text);
    }
}

TEST(RecordText, KeepsEveryBitOfAShot) {
    for (const ReplayRecord& record : test::played_match("m1", kShots)) {
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

TEST(RecordText, OfTheEndGameIsByteForByteWhatItWasWithoutSettings) {
    const std::string file = test::replay_file(test::played_match("m1", 100));
    EXPECT_EQ(checksum_text(file), "8a01684824b297e5");
}

TEST(RecordText, IsOneLine) {
    EXPECT_EQ(to_text(1, SeatRecord{Seat{1}, "a\nb"}).find('\n'), std::string::npos);
}

TEST(RecordText, EveryMissingFieldIsNamed) {
    const Json whole = shot_json();
    ASSERT_EQ(fault_of(whole), "ok");
    for (const auto& [key, unused] : whole.items()) {
        Json json = whole;
        json.erase(key);
        EXPECT_EQ(fault_of(json), "/" + key);
    }
}

TEST(RecordText, EveryFieldOfAnotherTypeIsNamed) {
    const Json whole = shot_json();
    for (const auto& [key, unused] : whole.items()) {
        for (const Json& wrong :
             {Json(nullptr), Json(true), Json(-1), Json::array({Json::object()})}) {
            Json json = whole;
            json[key] = wrong;
            EXPECT_EQ(fault_of(json).substr(0, key.size() + 1), "/" + key) << wrong;
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
    json["scene"]["effects"]["wind"] = Json::object();
    EXPECT_EQ(fault_of(json), "/scene/effects/wind");
}

TEST(RecordText, ASceneThatCannotBeSimulatedIsRefused) {
    Json json = shot_json();
    json["scene"]["balls"][1]["r"] = json["scene"]["balls"][0]["r"];
    EXPECT_EQ(fault_of(json).substr(0, 12), "/scene/balls");
    json = shot_json();
    json["scene"].erase("strike");
    EXPECT_EQ(fault_of(json), "/scene/strike");
}

TEST(RecordText, AnotherFormatIsRefused) {
    Json json = Json::parse(to_text(1, MatchRecord{"m1", "end_game", "poolhall 0.1.0", 0}));
    json["format"] = "poolhall.replay/2";
    EXPECT_EQ(fault_of(json), "/format");
    json.erase("format");
    EXPECT_EQ(fault_of(json), "/format");
}

TEST(RecordText, KeepsTheSettingsOfAMatch) {
    MatchRecord match{"m1", "end_game", "poolhall 0.1.0", 0};
    EXPECT_EQ(to_text(1, match).find("settings"), std::string::npos) << "as before there were any";
    match.settings.emplace().solver = SolverSpec{SolverKind::kEvent, 30};
    match.settings->effects.emplace().rolling = RollingSpec{0.01};
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
        EXPECT_EQ(
            fault_of(Json::parse(to_text(1, MatchRecord{id, "end_game", "poolhall 0.1.0", 0}))),
            "/match");
    }
    EXPECT_TRUE(is_match_id("Az09_-"));
    EXPECT_FALSE(is_match_id(std::string(65, 'a')));
}

TEST(RecordText, EventTimesAreAllThereOrNone) {
    Json json = shot_json();
    json["event_times"] = Json::array();
    EXPECT_EQ(fault_of(json), "ok");
    json["event_times"] = Json::array({0.5});
    EXPECT_EQ(fault_of(json), "/event_times");
}

TEST(RecordText, WhatIsNotJsonIsSaidToBeNone) {
    for (const std::string text : {"", "{", "[1", "nul", "{}{}"}) {
        const auto record = record_from_text(text);
        ASSERT_FALSE(record) << text;
        EXPECT_FALSE(record.error().is_json) << text;
    }
    EXPECT_TRUE(record_from_text("[]").error().is_json);
    const auto number = record_from_text("{\"n\":1e999}");
    ASSERT_FALSE(number);
    EXPECT_TRUE(number.error().is_json);
    EXPECT_EQ(number.error().pointer, "/n");
}

}  // namespace
}  // namespace poolhall::protocol
