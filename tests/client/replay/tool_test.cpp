#include "protocol/replay/line.hpp"
#include "protocol/replay/record_text.hpp"
#include "shared/game/end_game.hpp"
#include "shared/physics/edition.hpp"
#include "tests/server/store/store_fixture.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <SQLiteCpp/Database.h>
#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <sys/wait.h>

// The real program on a real store, and on files that it exported.
namespace poolhall::client {
namespace {

using namespace poolhall::test;
using protocol::MoveRecord;

/// What a run of the program gave; `text` is both its outputs, as a terminal shows them.
struct ProgramRun {
    int status = -1;
    std::string text;

    [[nodiscard]] bool says(std::string_view part) const {
        return text.find(part) != std::string::npos;
    }
};

class ReplayTool : public testing::Test {
  protected:
    static constexpr std::uint32_t kShots = 6;

    void SetUp() override {
        store_match(*open_store(data()), "m1", "BCDFGH", played_match("m1", kShots));
    }

    [[nodiscard]] std::filesystem::path data() const { return folder_.path() / "data"; }

    [[nodiscard]] std::string path(const std::string& name) const {
        return (folder_.path() / name).string();
    }

    [[nodiscard]] ProgramRun run(const std::string& arguments) const {
        const std::string command =
            "POOLHALL_DATA='" + data().string() + "' " POOLHALL_REPLAY " " + arguments + " 2>&1";
        ProgramRun run;
        FILE* output = popen(command.c_str(), "r");
        if (output == nullptr) return run;
        std::array<char, 4096> part{};
        for (std::size_t size = 1; size > 0;) {
            size = fread(part.data(), 1, part.size(), output);
            run.text.append(part.data(), size);
        }
        const int status = pclose(output);
        run.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        return run;
    }

    /// Changes shot 3 in the store and gives it a good checksum, as a forger would.
    void forge_shot_3() const {
        auto records = played_match("m1", kShots);
        std::uint64_t n = 0;
        for (auto& record : records) {
            ++n;
            auto* move = std::get_if<MoveRecord>(&record);
            if (move == nullptr || !move->shot || move->shot->shot != 3) continue;
            move->shot->trace ^= 1U;
            const std::string body = protocol::to_text(n, record);
            SQLite::Database(database(), SQLite::OPEN_READWRITE)
                .exec("UPDATE records SET body = '" + body + "', sum = '" +
                      protocol::checksum_text(body) + "' WHERE n = " + std::to_string(n));
        }
    }

    [[nodiscard]] std::string database() const { return (data() / "poolhall.sqlite").string(); }

  private:
    TemporaryFolder folder_;
};

TEST_F(ReplayTool, ListsReplays) {
    const ProgramRun list = run("list");
    EXPECT_EQ(list.status, 0);
    EXPECT_TRUE(list.says("m1")) << list.text;
    EXPECT_TRUE(list.says("Ann / Bob")) << list.text;
    EXPECT_TRUE(list.says(" shots  games    score ")) << list.text;
    EXPECT_TRUE(list.says("     6      2      1:1  2023-11-14 ")) << list.text;
}

TEST_F(ReplayTool, ShowsAReplay) {
    const ProgramRun show = run("show m1");
    EXPECT_EQ(show.status, 0);
    EXPECT_TRUE(show.says("match m1, end_game, created 2023-11-14 22:13:20 UTC by poolhall 0.1.0"))
        << show.text;
    EXPECT_TRUE(show.says("turn_passes"));
    EXPECT_TRUE(show.says("end: both players left"));
}

TEST_F(ReplayTool, ShowsEveryMoveInWords) {
    MatchSettings settings;
    settings.shot_clock_s = 30;
    settings.race_to = 3;
    settings.breaks = BreakOrder::kWinner;
    Match match({&kEndGameRules, Seat{0}, settings});
    match.start_clock(0);
    protocol::MatchRecord first = match_record("m3");
    first.settings = settings;
    std::vector<protocol::ReplayRecord> records{first, protocol::SeatRecord{Seat{0}, "Ann"}};
    const auto play = [&](Seat seat, const Move& move) {
        MatchStep step = match.play(seat, move, 100'000);
        records.emplace_back(protocol::move_record(step));
        match.commit(std::move(step), 0);
    };
    play(Seat{0}, Place{{end_game::kBaseLineX, 0.1}});
    play(Seat{0}, TimeOut{});
    play(Seat{1}, Shoot{Stroke{{-1, 0.02}, {}}});
    play(Seat{1}, Concede{});
    play(Seat{1}, Agree{});
    play(Seat{0}, Agree{});
    write_file(path("words.jsonl"), replay_file(records));
    const ProgramRun show = run("show --file " + path("words.jsonl"));
    EXPECT_EQ(show.status, 0) << show.text;
    for (const std::string part :
         {"settings: race to 3, the winner breaks, 30 s a shot\ngame 1, first shot by seat 0\n",
          "     -     0  Ann             places the cue ball at -0.3875,0.1000 m ",
          "has run out of time ", " timed_out ", "     1     1  seat 1          -0.9998,0.0200 ",
          "concedes the game ", " conceded ", "      won by Ann\n", "agrees to a rematch ",
          "game 2, first shot by seat 0\n"}) {
        EXPECT_TRUE(show.says(part)) << part << '\n' << show.text;
    }
    EXPECT_TRUE(run("verify --file " + path("words.jsonl")).says("1 shot, all as recorded"));
}

TEST_F(ReplayTool, ShowsHowTheCueWasHeld) {
    auto records = played_match("m3", 1);
    auto& stroke = std::get<Shoot>(std::get<MoveRecord>(records.at(4)).move).strike;
    stroke.offset = {-0.3, 0.25};
    stroke.elevation = 0.1;
    write_file(path("cue.jsonl"), replay_file(records));
    const ProgramRun show = run("show --file " + path("cue.jsonl"));
    EXPECT_TRUE(show.says("      offset 0.30 left, 0.25 up; elevation 0.100\n")) << show.text;
}

TEST_F(ReplayTool, AShotOfAnotherEditionIsNeitherDamagedNorDiverged) {
    auto records = played_match("m3", kShots);
    for (auto& record : records) {
        auto* move = std::get_if<MoveRecord>(&record);
        if (move == nullptr || !move->shot) continue;
        move->shot->edition = move->shot->shot % 2 == 0 ? 0 : kPhysicsEdition + 1;
        move->shot->kernel = "of_old";
        if (move->shot->shot == kShots) move->shot->trace ^= 1U;
    }
    write_file(path("other.jsonl"), replay_file(records));
    const ProgramRun verify = run("verify --file " + path("other.jsonl"));
    EXPECT_EQ(verify.status, 0) << verify.text;
    EXPECT_TRUE(verify.says(", there is no kernel of_old here: simulated by drag_rails_pockets\n"));
    EXPECT_TRUE(verify.says("played by edition 0 of the physics: same final states"))
        << verify.text;
    EXPECT_TRUE(verify.says("6 shots, 1 with another result by another edition, none diverged\n"))
        << verify.text;
}

TEST_F(ReplayTool, AFileOfALaterVersionIsNotCalledDamaged) {
    std::string record = protocol::to_text(1, match_record("m3"));
    record.replace(record.find("replay/2"), 8, "replay/3");
    record.insert(record.size() - 1, R"(,"weather":"fine")");
    write_file(path("later.jsonl"), protocol::to_line({protocol::checksum_text(record), record}));
    const ProgramRun show = run("show --file " + path("later.jsonl"));
    EXPECT_EQ(show.status, 2);
    EXPECT_TRUE(
        show.says("later.jsonl cannot be read: line 1, byte 0: /format: the version "
                  "\"poolhall.replay/3\" is none that this program knows"))
        << show.text;
}

/// What `verify --all` says of the others than 2863346bdbd43125, with Mathavan's rail, which is
/// played otherwise since edition 2.
std::string of_the_others(const std::string& verified) {
    std::istringstream lines(verified);
    std::string others;
    for (std::string line, of_one; std::getline(lines, line);) {
        of_one += line + "\n";
        if (!line.starts_with("replay ")) continue;
        if (!line.starts_with("replay 2863346bdbd43125")) others += of_one;
        of_one.clear();
    }
    return others;
}

/// Columns have other widths since.
std::string without_blanks(std::string text) {
    std::erase(text, ' ');
    return text;
}

TEST_F(ReplayTool, ShowsVerifiesAndExportsWhatVersion1Wrote) {
    const std::filesystem::path samples = POOLHALL_SOURCE_DIR "/tests/golden/replay_v1";
    std::filesystem::create_directory(path("old"));
    std::filesystem::copy_file(samples / "poolhall.sqlite", path("old/poolhall.sqlite"));
    for (const bool migrated : {false, true}) {
        if (migrated) open_store(path("old")).reset();
        const ProgramRun verify = run("verify --all --data " + path("old"));
        EXPECT_EQ(verify.status, 0);
        EXPECT_EQ(of_the_others(verify.text), of_the_others(read_file(samples / "verify.txt")));
        EXPECT_TRUE(
            verify.says("replay 2863346bdbd43125: 2 shots, 2 with another result by "
                        "another edition, none diverged"))
            << verify.text;
        for (const auto& entry : std::filesystem::directory_iterator(samples)) {
            if (entry.path().extension() != ".jsonl") continue;
            const std::string file = read_file(entry.path());
            const std::size_t at = file.find(R"("match":")") + 9;
            const std::string id = file.substr(at, file.find('"', at) - at);
            EXPECT_EQ(run("export " + id + " - --data " + path("old")).text, file);
            const auto shown = samples / "show" / (entry.path().stem().string() + ".txt");
            EXPECT_EQ(without_blanks(run("show " + id + " --data " + path("old")).text),
                      without_blanks(read_file(shown)));
        }
        const ProgramRun list = run("list --data " + path("old"));
        EXPECT_TRUE(list.says("e4f624b65a67c363         end_game       5      3      2:1  "))
            << list.text;
    }
}

TEST_F(ReplayTool, ShowsTheRecordsAsJson) {
    const ProgramRun show = run("show m1 --json");
    EXPECT_EQ(show.status, 0);
    EXPECT_TRUE(show.text.starts_with(R"({"n":1,"kind":"match","format":"poolhall.replay/2",)"))
        << show.text;
}

TEST_F(ReplayTool, VerifiesAReplay) {
    const ProgramRun verify = run("verify m1");
    EXPECT_EQ(verify.status, 0);
    EXPECT_TRUE(verify.says("shot 6: ok ")) << verify.text;
    EXPECT_TRUE(verify.says("replay m1: 6 shots, all as recorded\n")) << verify.text;
}

TEST_F(ReplayTool, ExportsWhatTheStoreHolds) {
    ASSERT_EQ(run("export m1 " + path("m1.jsonl")).status, 0);
    const std::string file = read_file(path("m1.jsonl"));
    EXPECT_EQ(file, replay_file(played_match("m1", kShots)));
    EXPECT_EQ(run("export m1 -").text, file);
    EXPECT_EQ(run("verify --file " + path("m1.jsonl")).status, 0);
    EXPECT_EQ(run("show --file " + path("m1.jsonl")).text, run("show m1").text);
}

TEST_F(ReplayTool, ShowsVerifiesAndExportsAMatchWithSettings) {
    const auto records = played_match("m2", kShots, {test::pool_settings()});
    store_match(*open_store(data()), "m2", "JKLMNP", records);
    const ProgramRun show = run("show m2");
    EXPECT_TRUE(show.says("by poolhall 0.1.0, with physics of its own\n")) << show.text;
    EXPECT_TRUE(show.says("event         slide_roll_spin_end_game ")) << show.text;
    EXPECT_TRUE(
        show.says("      called for: sliding, rolling, spin, rails, pockets (idle), throw\n"))
        << show.text;
    EXPECT_TRUE(run("show m1").says("euler:30      drag_rails_pockets "));
    EXPECT_TRUE(run("verify m2").says("replay m2: 6 shots, all as recorded\n"));
    EXPECT_EQ(run("export m2 -").text, replay_file(records));
}

TEST_F(ReplayTool, WorksWhileAServerWrites) {
    const auto store = open_store(data());
    ASSERT_EQ(done(*store, server::CreateMatchJob{"JKLMNP", match_record("m2")}), "ok");
    EXPECT_TRUE(run("list").says("m2"));
    const ProgramRun verify = run("verify --all");
    EXPECT_EQ(verify.status, 0);
    EXPECT_TRUE(verify.says("replay m2: 0 shots, all as recorded; the match has no end record yet"))
        << verify.text;
    EXPECT_EQ(done(*store, server::AppendMoveJob{"m2", some_move(0)}), "ok");
}

TEST_F(ReplayTool, NamesTheShotThatWasForgedAndGoesOn) {
    forge_shot_3();
    const ProgramRun verify = run("verify m1");
    EXPECT_EQ(verify.status, 1);
    EXPECT_TRUE(verify.says("shot 3: DIVERGED hash ")) << verify.text;
    EXPECT_TRUE(verify.says("shot 4: ok ")) << verify.text;
    EXPECT_TRUE(verify.says("replay m1: 6 shots, 1 diverged, the first is shot 3\n"))
        << verify.text;
    EXPECT_EQ(run("verify --all").status, 1);
}

TEST_F(ReplayTool, ReadsStandardInputWhereTheFileIsADash) {
    ASSERT_EQ(run("export m1 " + path("m1.jsonl")).status, 0);
    for (const std::string command : {"show", "show --json", "verify"}) {
        const ProgramRun piped = run(command + " --file - < " + path("m1.jsonl"));
        EXPECT_EQ(piped.status, 0) << piped.text;
        if (command == "verify") {
            EXPECT_TRUE(piped.says("standard input: 6 shots, all as recorded")) << piped.text;
        } else {
            EXPECT_EQ(piped.text, run(command + " m1").text);
        }
    }
    const ProgramRun empty = run("verify --file - < /dev/null");
    EXPECT_EQ(empty.status, 2);
    EXPECT_TRUE(empty.says("standard input is damaged: line 1, byte 0: there is no record"))
        << empty.text;
}

TEST_F(ReplayTool, ReadsAFileWithTheLineEndsOfOtherSystems) {
    const std::string file = replay_file(played_match("m1", kShots));
    std::string other;
    for (const char byte : file)
        other += byte == '\n' ? std::string("\r\n") : std::string(1, byte);
    write_file(path("crlf.jsonl"), other);
    EXPECT_EQ(run("verify --file " + path("crlf.jsonl")).status, 0);
    EXPECT_EQ(run("show --file " + path("crlf.jsonl")).text, run("show m1").text);
}

TEST_F(ReplayTool, LeavesNothingBesideTheStoreThatItReads) {
    for (const std::string command : {"list", "show m1", "verify --all", "export m1 -"})
        EXPECT_EQ(run(command).status, 0);
    EXPECT_FALSE(std::filesystem::exists(database() + "-wal"));
    EXPECT_FALSE(std::filesystem::exists(database() + "-shm"));
}

TEST_F(ReplayTool, ExportsThroughALinkAndKeepsTheModeOfWhatWasThere) {
    write_file(path("private.jsonl"), "old");
    std::filesystem::permissions(path("private.jsonl"), static_cast<std::filesystem::perms>(0600));
    std::filesystem::create_symlink("private.jsonl", path("link.jsonl"));
    ASSERT_EQ(run("export m1 " + path("link.jsonl")).status, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(path("link.jsonl")));
    EXPECT_EQ(read_file(path("private.jsonl")), replay_file(played_match("m1", kShots)));
    EXPECT_EQ(std::filesystem::status(path("private.jsonl")).permissions(),
              static_cast<std::filesystem::perms>(0600));
}

TEST_F(ReplayTool, ReadsADamagedFileUpToTheDamage) {
    const std::string file = replay_file(played_match("m1", kShots));
    write_file(path("cut.jsonl"), file.substr(0, file.size() / 2));
    for (const std::string command : {"show", "verify"}) {
        const ProgramRun damaged = run(command + " --file " + path("cut.jsonl"));
        EXPECT_EQ(damaged.status, 2);
        EXPECT_TRUE(damaged.says("shot")) << damaged.text;
        EXPECT_TRUE(damaged.says("cut.jsonl is damaged: line ")) << damaged.text;
        EXPECT_TRUE(damaged.says(": the last line is cut short")) << damaged.text;
    }
}

TEST_F(ReplayTool, ADamagedRecordInTheStoreIsNamed) {
    SQLite::Database(database(), SQLite::OPEN_READWRITE)
        .exec("UPDATE records SET body = replace(body, 'end_game', 'mad_game') WHERE n = 5");
    const ProgramRun verify = run("verify m1");
    EXPECT_EQ(verify.status, 2);
    EXPECT_TRUE(verify.says("replay m1 is damaged: line 5, byte ")) << verify.text;
    EXPECT_TRUE(verify.says(": the checksum does not match")) << verify.text;
}

TEST_F(ReplayTool, OddIdsAreUnknown) {
    for (const std::string id : {"m2", "../data/m1", "/etc/passwd", "'m1 OR 1=1'", "''"}) {
        for (const std::string command : {"show ", "verify "}) {
            const ProgramRun unknown = run(command + id);
            EXPECT_EQ(unknown.status, 2) << unknown.text;
            EXPECT_TRUE(unknown.says("there is no replay ")) << unknown.text;
        }
        EXPECT_EQ(run("export " + id + " " + path("out.jsonl")).status, 2);
        EXPECT_FALSE(std::filesystem::exists(path("out.jsonl")));
    }
}

TEST_F(ReplayTool, WhatCannotBeReadOrWrittenIsSaidInOneLine) {
    const std::vector<std::string> bad{
        "show --file " + path("none"), "show --file /",
        "list --data " + path("none"), "export m1 " + path("no/file"),
        "export m1 " + path("data"),   "verify --all > /dev/full"};
    for (const std::string& arguments : bad) {
        const ProgramRun failed = run(arguments);
        EXPECT_EQ(failed.status, 2) << arguments;
        EXPECT_TRUE(failed.text.starts_with("poolhall-replay: ") || arguments.ends_with("full"))
            << failed.text;
        EXPECT_LE(std::count(failed.text.begin(), failed.text.end(), '\n'), 1) << failed.text;
    }
    EXPECT_FALSE(std::filesystem::exists(path("data.part")));
}

TEST_F(ReplayTool, AWrongCommandLineIsBadInput) {
    for (const std::string arguments :
         {"", "play", "show", "show m1 --file x", "verify m1 --all", "export m1", "show m1 x"}) {
        EXPECT_EQ(run(arguments).status, 2) << arguments;
    }
    EXPECT_EQ(run("--help").status, 0);
    EXPECT_EQ(run("verify --help").status, 0);
}

TEST_F(ReplayTool, ControlCharactersDoNotReachTheTerminal) {
    auto records = played_match("m1", 1);
    std::get<protocol::EndRecord>(records.back()).reason = "\x1B[2J";
    std::get<protocol::MatchRecord>(records.front()).server = "\x1B]0;x\x07";
    write_file(path("odd.jsonl"), replay_file(records));
    const ProgramRun show = run("show --file " + path("odd.jsonl"));
    EXPECT_EQ(show.status, 0) << show.text;
    EXPECT_FALSE(show.says("\x1B")) << show.text;
}

}  // namespace
}  // namespace poolhall::client
