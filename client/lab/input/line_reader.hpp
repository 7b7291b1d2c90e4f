#pragma once

#include <array>
#include <cstddef>
#include <istream>
#include <string>

namespace poolhall::lab {

/// Reads lines in bounded memory.
class LineReader {
  public:
    /// A longer line is skipped. A thousand balls with every number written out take 0.3 MiB.
    static constexpr std::size_t kMaxLineBytes = std::size_t{16} << 20U;

    enum class Got { kLine, kTooLong, kEnd };

    explicit LineReader(std::istream& in) : in_(in) {}

    /// The next line, without its newline; empty if it is too long.
    [[nodiscard]] Got next(std::string& line);

    /// Of the line that next() gave, from 1.
    [[nodiscard]] std::size_t number() const { return number_; }

  private:
    /// Reads on when all that was read is used. False at the end.
    bool fill();

    std::istream& in_;
    std::array<char, std::size_t{1} << 16U> block_{};
    std::size_t used_ = 0;
    std::size_t filled_ = 0;
    std::size_t number_ = 0;
};

}  // namespace poolhall::lab
