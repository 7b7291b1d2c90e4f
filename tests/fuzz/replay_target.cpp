#include "protocol/replay/line.hpp"
#include "protocol/replay/reader.hpp"
#include "protocol/replay/record_text.hpp"
#include "tests/fuzz/targets.hpp"

#include <sstream>
#include <string>

namespace poolhall::fuzz {
namespace {

using namespace protocol;

std::size_t count_records(const std::string& file) {
    std::istringstream input(file);
    ReplayReader reader(input);
    std::size_t records = 0;
    while (reader.next())
        ++records;
    require(records > 0 || reader.damage(), "neither a record nor damage");
    return records;
}

}  // namespace

/// The bytes are a file, and also a record: no fuzzer guesses a checksum.
void replay(std::string_view bytes) {
    count_records(std::string(bytes));
    count_records(to_line({checksum_text(bytes), bytes}));
    const auto first = record_from_text(bytes);
    if (!first) return require(!first.error().reason.empty(), "refused without a reason");
    const std::string written = to_text(first->n, first->record);
    const auto second = record_from_text(written);
    require(second.ok(), "refused a record that was written");
    require(to_text(second->n, second->record) == written, "a record changed when it was read");
}

}  // namespace poolhall::fuzz
