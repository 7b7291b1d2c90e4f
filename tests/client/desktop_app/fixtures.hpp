#pragma once

#include "tests/client/play/fixtures.hpp"

#include <filesystem>

namespace poolhall::client {

/// A folder that is gone after the test.
class TemporaryFolder {
  public:
    TemporaryFolder();

    ~TemporaryFolder() { std::filesystem::remove_all(path); }

    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path path;
};

}  // namespace poolhall::client
