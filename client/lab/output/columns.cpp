#include "client/lab/output/columns.hpp"

#include <algorithm>

namespace poolhall::lab {

namespace {

constexpr std::size_t kGap = 3;

/// Characters: bytes that do not go on with one.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
    }));
}

std::vector<std::size_t> widths_of(const std::vector<std::vector<std::string>>& lines) {
    std::vector<std::size_t> widths;
    for (const auto& line : lines) {
        widths.resize(std::max(widths.size(), line.size()));
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], width_of(line[i]));
    }
    return widths;
}

}  // namespace

void Columns::print(std::ostream& out) const {
    const auto widths = widths_of(lines_);
    for (const auto& line : lines_) {
        std::string text;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string space(widths[i] - width_of(line[i]), ' ');
            const bool right = align_ == Align::kRight && i > 0;
            text += (right ? space + line[i] : line[i] + space) + std::string(kGap, ' ');
        }
        text.erase(text.find_last_not_of(' ') + 1);
        out << text << '\n';
    }
}

}  // namespace poolhall::lab
