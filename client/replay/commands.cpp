#include "client/replay/commands.hpp"

#include "client/files/output_file.hpp"
#include "client/replay/report.hpp"
#include "protocol/archive/archive.hpp"
#include "protocol/replay/log_follower.hpp"
#include "protocol/replay/reader.hpp"
#include "protocol/text.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>

namespace poolhall::client {

namespace {

using protocol::ReplayArchive;

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

Status fail(const ReplayTool& tool, const std::string& reason) {
    tool.error << "poolhall-replay: " << reason << '\n';
    return Status::kBadInput;
}

Status worse(Status a, Status b) {
    return std::max(a, b);
}

/// A match of the store as a replay file; says what is wrong if there is none.
std::optional<std::string> load(const ReplayTool& tool, const ReplayArchive& archive,
                                const std::string& id) {
    auto text = archive.export_match(id);
    if (!text) {
        fail(tool, text.error().reason);
        return std::nullopt;
    }
    if (!text.value())
        fail(tool, "there is no replay " + protocol::shown(id) + " in " + tool.data.string());
    return *std::move(text);
}

std::optional<std::string> load(const ReplayTool& tool, const std::string& id) {
    const auto archive = ReplayArchive::open(tool.data);
    if (archive) return load(tool, *archive, id);
    fail(tool, archive.error().reason);
    return std::nullopt;
}

/// The chosen replay, open for reading; says what is wrong if there is none.
std::unique_ptr<std::istream> open(const ReplayTool& tool, const ReplayChoice& choice) {
    if (choice.file.empty()) {
        auto text = load(tool, choice.id);
        return text ? std::make_unique<std::istringstream>(*std::move(text)) : nullptr;
    }
    if (choice.file == "-") return std::make_unique<std::istream>(tool.in.rdbuf());
    auto file = std::make_unique<std::ifstream>(choice.file, std::ios::binary);
    if (*file) return file;
    fail(tool, choice.file + " cannot be opened");
    return nullptr;
}

std::string title(const ReplayChoice& choice) {
    if (choice.file == "-") return "standard input";
    return choice.file.empty() ? "replay " + protocol::shown(choice.id) : choice.file;
}

/// Says where a reading stopped, if it did not come to a good end.
Status finish(const ReplayTool& tool, const protocol::ReplayReader& reader,
              const ReplayChoice& choice) {
    if (!reader.damage()) return Status::kGood;
    const bool newer = reader.damage()->kind == protocol::DamageKind::kUnknownVersion;
    return fail(tool, title(choice) + (newer ? " cannot be read: " : " is damaged: ") +
                          reader.damage()->text());
}

/// How a verification went, record by record.
struct Tally {
    std::uint32_t shots = 0;
    std::uint32_t elsewhere = 0;  ///< shots that another edition played, with another result
    std::uint32_t diverged = 0;   ///< records
    std::string first;            ///< the first record that diverged

    void count(const protocol::Followed& followed) {
        if (followed.shot) ++shots;
        if (!followed.found.deviations.empty()) {
            if (diverged++ == 0) first = followed.subject;
        } else if (followed.shot && !followed.shot->as_recorded) {
            ++elsewhere;
        }
    }

    [[nodiscard]] std::string text() const {
        std::string text = std::to_string(shots) + (shots == 1 ? " shot, " : " shots, ");
        if (elsewhere > 0)
            text += std::to_string(elsewhere) + " with another result by another edition, ";
        if (diverged == 0) return text + (elsewhere > 0 ? "none diverged" : "all as recorded");
        return text + std::to_string(diverged) + " diverged, the first is " + first;
    }
};

Status verify(const ReplayTool& tool, std::istream& input, const ReplayChoice& choice) {
    protocol::ReplayReader reader(input);
    protocol::LogFollower follower;
    Tally tally;
    while (const auto numbered = reader.next()) {
        const auto followed = follower.follow(numbered->record);
        if (numbered->n == 1 && !follower.knows_rules()) {
            tool.out << "the rules of this game are not known here: only the shots themselves are "
                        "checked\n";
        }
        print_followed(tool.out, followed);
        tally.count(followed);
    }
    tool.out << title(choice) << ": " << tally.text();
    tool.out << (reader.ended() || reader.damage() ? "\n" : "; the match has no end record yet\n");
    const Status verified = tally.diverged == 0 ? Status::kGood : Status::kDiverged;
    return worse(verified, finish(tool, reader, choice));
}

Status write_file(const ReplayTool& tool, const std::string& file, const std::string& text) {
    files::OutputFile output(file);
    output.stream() << text;
    output.finish();
    return output.fault() ? fail(tool, *output.fault()) : Status::kGood;
}

}  // namespace

Status list_replays(const ReplayTool& tool) {
    const auto archive = ReplayArchive::open(tool.data);
    if (!archive) return fail(tool, archive.error().reason);
    const auto replays = archive->list(kAll);
    if (!replays) return fail(tool, replays.error().reason);
    print_list(tool.out, *replays);
    return Status::kGood;
}

Status show_replay(const ReplayTool& tool, const ReplayChoice& choice, ShowForm form) {
    const auto input = open(tool, choice);
    if (!input) return Status::kBadInput;
    protocol::ReplayReader reader(*input);
    ReplayPrinter printer(tool.out);
    while (const auto numbered = reader.next()) {
        if (form == ShowForm::kJson) {
            tool.out << reader.text() << '\n';
        } else {
            printer.print(numbered->record);
        }
    }
    return finish(tool, reader, choice);
}

Status verify_replay(const ReplayTool& tool, const ReplayChoice& choice) {
    const auto input = open(tool, choice);
    return input ? verify(tool, *input, choice) : Status::kBadInput;
}

Status verify_all(const ReplayTool& tool) {
    const auto archive = ReplayArchive::open(tool.data);
    if (!archive) return fail(tool, archive.error().reason);
    const auto replays = archive->list(kAll);
    if (!replays) return fail(tool, replays.error().reason);
    Status status = Status::kGood;
    for (const auto& replay : *replays) {
        const auto text = load(tool, *archive, replay.id);
        if (!text) {
            status = Status::kBadInput;
            continue;
        }
        std::istringstream input(*text);
        status = worse(status, verify(tool, input, {replay.id, ""}));
    }
    return status;
}

Status export_replay(const ReplayTool& tool, const std::string& id, const std::string& file) {
    const auto text = load(tool, id);
    if (!text) return Status::kBadInput;
    if (file != "-") return write_file(tool, file, *text);
    tool.out << *text;
    return Status::kGood;
}

}  // namespace poolhall::client
