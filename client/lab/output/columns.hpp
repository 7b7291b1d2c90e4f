#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace poolhall::lab {

/// Lines of cells, printed so that the cells of a column stand below each other. Cells are UTF-8;
/// lines may have fewer of them than others.
class Columns {
  public:
    enum class Align {
        kLeft,
        kRight,  ///< all but the first column, for numbers
    };

    explicit Columns(Align align = Align::kLeft) : align_(align) {}

    void add(std::vector<std::string> line) { lines_.push_back(std::move(line)); }

    void print(std::ostream& out) const;

  private:
    Align align_;
    std::vector<std::vector<std::string>> lines_;
};

}  // namespace poolhall::lab
