#include "server/store/writer.hpp"

#include <utility>

namespace poolhall::server {

ReplayStore::Writer::Writer(std::unique_ptr<StoreDatabase> database, std::size_t max_queued)
    : database_(std::move(database)), max_queued_(max_queued), thread_([this] { run(); }) {}

ReplayStore::Writer::~Writer() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void ReplayStore::Writer::submit(StoreJob job, StoreCompletion completion) {
    {
        const std::lock_guard lock(mutex_);
        if (queue_.size() < max_queued_) {
            queue_.push_back({std::move(job), std::move(completion)});
            wake_.notify_one();
            return;
        }
    }
    completion("the replay store cannot keep up: " + std::to_string(max_queued_) + " jobs wait");
}

void ReplayStore::Writer::flush() {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [this] { return queue_.empty() && !writing_; });
}

std::size_t ReplayStore::Writer::backlog() const {
    const std::lock_guard lock(mutex_);
    return queue_.size();
}

/// Jobs that arrive while a transaction is made durable wait for the next one, and share it: the
/// busier the server, the more jobs a transaction has.
void ReplayStore::Writer::run() {
    for (auto batch = wait_for_jobs(); !batch.empty(); batch = wait_for_jobs()) {
        std::vector<const StoreJob*> jobs;
        jobs.reserve(batch.size());
        for (const Queued& queued : batch)
            jobs.push_back(&queued.job);
        const std::vector<JobFailure> failures = database_->apply(jobs);
        for (std::size_t i = 0; i < batch.size(); ++i)
            batch[i].completion(failures[i]);
    }
}

/// All that is queued; empty when the store closes.
std::vector<ReplayStore::Writer::Queued> ReplayStore::Writer::wait_for_jobs() {
    std::unique_lock lock(mutex_);
    writing_ = false;
    if (queue_.empty()) idle_.notify_all();
    wake_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
    writing_ = !queue_.empty();
    return std::exchange(queue_, {});
}

}  // namespace poolhall::server
