#pragma once

#include "server/store/replay_store.hpp"
#include "server/store/store_database.hpp"

#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace poolhall::server {

/// The thread that writes, and its queue.
class ReplayStore::Writer {
  public:
    Writer(std::unique_ptr<StoreDatabase> database, std::size_t max_queued);
    /// Does what is queued first.
    ~Writer();
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    Writer(Writer&&) = delete;
    Writer& operator=(Writer&&) = delete;

    void submit(StoreJob job, StoreCompletion completion);
    void flush();
    [[nodiscard]] std::size_t backlog() const;

  private:
    struct Queued {
        StoreJob job;
        StoreCompletion completion;
    };

    void run();
    std::vector<Queued> wait_for_jobs();

    std::unique_ptr<StoreDatabase> database_;
    std::size_t max_queued_;
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::condition_variable idle_;
    std::vector<Queued> queue_;  ///< guarded by mutex_
    bool writing_ = false;       ///< guarded by mutex_
    bool stopping_ = false;      ///< guarded by mutex_
    std::thread thread_;         ///< last: it uses all the others
};

}  // namespace poolhall::server
