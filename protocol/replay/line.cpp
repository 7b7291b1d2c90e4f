#include "protocol/replay/line.hpp"

#include "shared/physics/scene/trace.hpp"

namespace poolhall::protocol {

namespace {

constexpr std::string_view kBeforeSum = R"({"sum":")";
constexpr std::string_view kBeforeRecord = R"(","record":)";
constexpr std::string_view kAfterRecord = "}";
constexpr std::size_t kSumDigits = 16;
constexpr std::size_t kRecordAt = kBeforeSum.size() + kSumDigits + kBeforeRecord.size();

bool is_hex(std::string_view text) {
    return text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace

std::string checksum_text(std::string_view bytes) {
    return to_hex(checksum(bytes));
}

std::string to_line(const LineParts& parts) {
    std::string line;
    line.reserve(kRecordAt + parts.record.size() + kAfterRecord.size() + 1);
    line.append(kBeforeSum).append(parts.sum).append(kBeforeRecord);
    line.append(parts.record).append(kAfterRecord).append("\n");
    return line;
}

std::optional<LineParts> split_line(std::string_view line) {
    if (line.size() <= kRecordAt + kAfterRecord.size()) return std::nullopt;
    if (!line.starts_with(kBeforeSum) || !line.ends_with(kAfterRecord)) return std::nullopt;
    const std::string_view sum = line.substr(kBeforeSum.size(), kSumDigits);
    if (!is_hex(sum)) return std::nullopt;
    if (line.substr(kBeforeSum.size() + kSumDigits, kBeforeRecord.size()) != kBeforeRecord) {
        return std::nullopt;
    }
    line.remove_prefix(kRecordAt);
    line.remove_suffix(kAfterRecord.size());
    return LineParts{sum, line};
}

}  // namespace poolhall::protocol
