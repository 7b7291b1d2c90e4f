#include "client/lab/output/columns.hpp"

#include "protocol/intake/text_width.hpp"

#include <algorithm>

namespace poolhall::lab {

namespace {

using protocol::text_width;

constexpr std::size_t kGap = 3;

std::vector<std::size_t> widths_of(const std::vector<std::vector<std::string>>& lines) {
    std::vector<std::size_t> widths;
    for (const auto& line : lines) {
        widths.resize(std::max(widths.size(), line.size()));
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], text_width(line[i]));
    }
    return widths;
}

}  // namespace

void Columns::print(std::ostream& out) const {
    const auto widths = widths_of(lines_);
    for (const auto& line : lines_) {
        std::string text;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string space(widths[i] - text_width(line[i]), ' ');
            const bool right = align_ == Align::kRight && i > 0;
            text += (right ? space + line[i] : line[i] + space) + std::string(kGap, ' ');
        }
        text.erase(text.find_last_not_of(' ') + 1);
        out << text << '\n';
    }
}

}  // namespace poolhall::lab
