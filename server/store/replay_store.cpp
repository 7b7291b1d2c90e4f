#include "server/store/replay_store.hpp"

#include "server/store/store_database.hpp"
#include "server/store/writer.hpp"

#include <utility>

namespace poolhall::server {

Result<std::unique_ptr<ReplayStore>, StoreError> ReplayStore::open(const ReplayStoreSpec& spec) {
    auto database = StoreDatabase::open(spec.data);
    if (!database) return StoreError{database.error().reason};
    auto writer = std::make_unique<Writer>(std::move(*database), spec.max_queued);
    return std::unique_ptr<ReplayStore>(new ReplayStore(spec.data, std::move(writer)));
}

ReplayStore::ReplayStore(std::filesystem::path data, std::unique_ptr<Writer> writer)
    : data_(std::move(data)), writer_(std::move(writer)) {}

ReplayStore::~ReplayStore() = default;

void ReplayStore::submit(StoreJob job, StoreCompletion completion) {
    writer_->submit(std::move(job), std::move(completion));
}

void ReplayStore::flush() {
    writer_->flush();
}

std::size_t ReplayStore::backlog() const {
    return writer_->backlog();
}

Result<protocol::ReplayArchive, protocol::ArchiveError> ReplayStore::open_archive() const {
    return protocol::ReplayArchive::open(data_);
}

}  // namespace poolhall::server
