#include "tests/client/desktop_app/fixtures.hpp"

#include <cstdlib>
#include <stdexcept>

namespace poolhall::client {

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "poolhall-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path = name;
}

}  // namespace poolhall::client
