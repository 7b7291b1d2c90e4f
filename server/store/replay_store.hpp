#pragma once

#include "protocol/archive/archive.hpp"
#include "protocol/replay/record.hpp"
#include "server/store/job.hpp"
#include "shared/result.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace poolhall::server {

struct StoreError {
    std::string reason;  ///< one sentence with the path
};

/// A match as a restarted server finds it.
struct StoredMatch {
    struct StoredSeat {
        std::string name;  ///< empty: the seat is open
        std::string token_hash;
    };

    std::string id;
    std::string code;
    std::array<StoredSeat, kSeatCount> seats;
    std::vector<protocol::ReplayRecord> records;
};

struct OpenMatches {
    std::vector<StoredMatch> matches;  ///< oldest first
    std::vector<std::string>
        damaged;  ///< one sentence for each open match that could not be read whole
};

struct ReplayStoreSpec {
    std::filesystem::path data;  ///< folder; created if it does not exist
    std::size_t max_queued =
        4096;  ///< jobs; more: longer waits and more memory before a job is refused
};

/// The durable log of all matches, in SQLite. One thread writes: it takes all jobs that wait into
/// one transaction, so that they share the cost of making it durable. Safe to use from any thread.
class ReplayStore {
  public:
    /// Opens or creates the store and checks it. Only one server can have a folder open.
    [[nodiscard]] static Result<std::unique_ptr<ReplayStore>, StoreError> open(
        const ReplayStoreSpec& spec);

    /// Does what is queued, then closes.
    ~ReplayStore();
    ReplayStore(const ReplayStore&) = delete;
    ReplayStore& operator=(const ReplayStore&) = delete;
    ReplayStore(ReplayStore&&) = delete;
    ReplayStore& operator=(ReplayStore&&) = delete;

    /// Queues a job; the store gives each record its number. `completion` is called exactly once:
    /// from the writer's thread, or at once if the queue is full. It must neither throw nor block.
    /// Jobs that one thread submits are done in their order; a failed job does not stop the later
    /// ones.
    void submit(StoreJob job, StoreCompletion completion);

    /// Waits until all that was queued is done and every completion has been called.
    void flush();

    /// Jobs that are queued and not yet begun.
    [[nodiscard]] std::size_t backlog() const;

    /// The matches that were not closed, for a server that starts.
    [[nodiscard]] Result<OpenMatches, StoreError> load_open_matches() const;

    /// A connection of its own for reading.
    [[nodiscard]] Result<protocol::ReplayArchive, protocol::ArchiveError> open_archive() const;

  private:
    class Writer;
    ReplayStore(std::filesystem::path data, std::unique_ptr<Writer> writer);

    std::filesystem::path data_;
    std::unique_ptr<Writer> writer_;
};

}  // namespace poolhall::server
