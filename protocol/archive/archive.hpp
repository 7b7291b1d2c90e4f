#pragma once

#include "protocol/archive/database.hpp"
#include "shared/game/game_state.hpp"
#include "shared/result.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace poolhall::protocol {

class ReadConnection;

/// What a list shows of a match.
struct ReplaySummary {
    std::uint64_t position = 0;  ///< rises from match to match; where the next page begins
    std::string id;
    std::string game;
    PerSeat<std::string> names;     ///< who sat there last; empty if nobody did
    PerSeat<std::uint32_t> wins{};  ///< games that they have won since they sat down
    std::uint32_t games = 0;        ///< finished
    std::uint32_t shots = 0;
    std::int64_t created_ms = 0;            ///< Unix time, ms
    std::optional<std::int64_t> closed_ms;  ///< none while the match is open
};

struct ArchiveError {
    std::string reason;  ///< one sentence with the path
};

/// A read-only connection to a replay store, of whatever version, which leaves no file behind. A
/// server may begin, end and write to the store meanwhile, in this process or another. For one
/// thread at a time; opening one costs some 0.1 ms.
class ReplayArchive {
  public:
    /// `data` is the folder that holds kDatabaseFile.
    [[nodiscard]] static Result<ReplayArchive, ArchiveError> open(
        const std::filesystem::path& data);

    /// At most `limit` matches, newest first; only those before `before`, a
    /// ReplaySummary::position, where given.
    [[nodiscard]] Result<std::vector<ReplaySummary>, ArchiveError> list(
        std::size_t limit, std::optional<std::uint64_t> before = std::nullopt) const;

    /// The match as a replay file, byte for byte as its records were stored; nothing if the id is
    /// unknown.
    [[nodiscard]] Result<std::optional<std::string>, ArchiveError> export_match(
        std::string_view id) const;

    ReplayArchive(ReplayArchive&& other) noexcept;
    ReplayArchive& operator=(ReplayArchive&& other) noexcept;
    ReplayArchive(const ReplayArchive&) = delete;
    ReplayArchive& operator=(const ReplayArchive&) = delete;
    ~ReplayArchive();

  private:
    ReplayArchive(std::filesystem::path path, std::unique_ptr<ReadConnection> connection);

    template <class Query>
    auto read(Query query) const
        -> Result<decltype(query(std::declval<SQLite::Database&>())), ArchiveError>;

    std::filesystem::path path_;
    std::unique_ptr<ReadConnection> connection_;
};

}  // namespace poolhall::protocol
