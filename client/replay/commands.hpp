#pragma once

#include <filesystem>
#include <istream>
#include <ostream>
#include <string>

// The commands of poolhall-replay; main.cpp reads the command line.
namespace poolhall::client {

/// What a command ends with; the program's exit status.
enum class Status : int {
    kGood = 0,
    kDiverged = 1,
    kBadInput = 2,  ///< also where a replay both diverges and is damaged
};

/// Where commands read and write.
struct ReplayTool {
    std::filesystem::path data;  ///< folder of the replay store
    std::istream& in;
    std::ostream& out;
    std::ostream& error;  ///< one line for each thing that is wrong
};

/// Which replay: one of the store, or an exported file.
struct ReplayChoice {
    std::string id;
    std::string file;  ///< empty: `id` counts; "-": ReplayTool::in
};

enum class ShowForm { kTable, kJson };

Status list_replays(const ReplayTool& tool);
Status show_replay(const ReplayTool& tool, const ReplayChoice& choice, ShowForm form);
Status verify_replay(const ReplayTool& tool, const ReplayChoice& choice);
Status verify_all(const ReplayTool& tool);
/// Writes to `tool.out` if `file` is "-". A file is there whole or not at all.
Status export_replay(const ReplayTool& tool, const std::string& id, const std::string& file);

}  // namespace poolhall::client
