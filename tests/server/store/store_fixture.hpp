#pragma once

#include "server/store/replay_store.hpp"
#include "tests/protocol/replay/played_match.hpp"

#include <filesystem>
#include <fstream>
#include <future>
#include <gtest/gtest.h>
#include <iterator>
#include <memory>
#include <string>

namespace poolhall::test {

/// A folder that is there for one test.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "poolhall-XXXXXX").string();
        if (mkdtemp(name.data()) != nullptr) path_ = name;
    }

    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    TemporaryFolder(TemporaryFolder&&) = delete;
    TemporaryFolder& operator=(TemporaryFolder&&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// The store of the folder; the test fails if it cannot be opened.
inline std::unique_ptr<server::ReplayStore> open_store(const std::filesystem::path& folder) {
    auto store = server::ReplayStore::open({folder});
    if (store) return std::move(*store);
    ADD_FAILURE() << store.error().reason;
    return nullptr;
}

/// Why the folder cannot be opened; "ok" if it can.
inline std::string open_failure(const std::filesystem::path& folder) {
    const auto store = server::ReplayStore::open({folder});
    return store ? "ok" : store.error().reason;
}

/// Submits a job and waits for its answer: "ok", or why not.
inline std::string done(server::ReplayStore& store, server::StoreJob job) {
    auto answer = std::make_shared<std::promise<std::string>>();
    auto future = answer->get_future();
    store.submit(std::move(job), [answer](const server::JobFailure& failure) {
        answer->set_value(failure.value_or("ok"));
    });
    return future.get();
}

/// The job that stores a record of a match; seats get "hash of NAME" as their token's hash.
inline server::StoreJob job_for(const std::string& match, const std::string& code,
                                const protocol::ReplayRecord& record) {
    using namespace server;
    using namespace protocol;
    if (const auto* first = std::get_if<MatchRecord>(&record)) return CreateMatchJob{code, *first};
    if (const auto* seat = std::get_if<SeatRecord>(&record)) {
        return SetSeatJob{match, *seat, seat->name.empty() ? "" : "hash of " + seat->name};
    }
    if (const auto* move = std::get_if<MoveRecord>(&record)) return AppendMoveJob{match, *move};
    return CloseMatchJob{match, std::get<EndRecord>(record)};
}

/// Stores the records of a match one by one; the test fails if one is not stored.
inline void store_match(server::ReplayStore& store, const std::string& id, const std::string& code,
                        const std::vector<protocol::ReplayRecord>& records) {
    for (const auto& record : records)
        EXPECT_EQ(done(store, job_for(id, code, record)), "ok");
}

inline std::string exported(const std::filesystem::path& folder, const std::string& id) {
    const auto archive = protocol::ReplayArchive::open(folder);
    if (!archive) return archive.error().reason;
    const auto text = archive->export_match(id);
    return text ? text->value_or("unknown") : text.error().reason;
}

inline std::string read_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_file(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

}  // namespace poolhall::test
