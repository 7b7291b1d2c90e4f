#include "client/lab/input/line_reader.hpp"

#include <algorithm>

namespace poolhall::lab {

bool LineReader::fill() {
    if (used_ < filled_) return true;
    used_ = 0;
    // What is there first: a pipe's writer may wait for the answer to its line.
    if (in_.peek() == std::istream::traits_type::eof()) {
        filled_ = 0;
        return false;
    }
    const std::streamsize ready =
        in_.readsome(block_.data(), static_cast<std::streamsize>(block_.size()));
    if (ready > 0) {
        filled_ = static_cast<std::size_t>(ready);
        return true;
    }
    block_[0] = static_cast<char>(in_.get());
    filled_ = 1;
    return true;
}

LineReader::Got LineReader::next(std::string& line) {
    line.clear();
    if (!fill()) return Got::kEnd;
    ++number_;
    bool too_long = false;
    while (fill()) {
        const char* const begin = block_.data() + used_;
        const char* const end = block_.data() + filled_;
        const char* const newline = std::find(begin, end, '\n');
        too_long =
            too_long || line.size() + static_cast<std::size_t>(newline - begin) > kMaxLineBytes;
        if (!too_long) line.append(begin, newline);
        used_ = static_cast<std::size_t>(newline - block_.data());
        if (newline == end) continue;
        ++used_;
        break;
    }
    if (!too_long) return Got::kLine;
    line = {};
    return Got::kTooLong;
}

}  // namespace poolhall::lab
