#pragma once

#include "shared/result.hpp"

#include <filesystem>
#include <string>

namespace poolhall::server {

/// Keeps a second server out of a data folder. The system drops it when the process ends, however
/// it ends.
class FolderLock {
  public:
    struct Error {
        std::string reason;  ///< one sentence with the path
    };

    [[nodiscard]] static Result<FolderLock, Error> take(const std::filesystem::path& folder);

    FolderLock(FolderLock&& other) noexcept;
    FolderLock& operator=(FolderLock&& other) noexcept;
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

  private:
    explicit FolderLock(int file) : file_(file) {}

    int file_ = -1;  ///< -1 once moved from
};

}  // namespace poolhall::server
