#pragma once

#include "client/lab/statistics/quantiles.hpp"

#include <optional>
#include <ostream>

namespace poolhall::lab {

/// Writes cells with commas between them; what is not there is an empty cell.
class CsvLine {
  public:
    explicit CsvLine(std::ostream& out) : out_(out) {}

    template <class Value>
    CsvLine& operator<<(const Value& value) {
        if (!first_) out_ << ',';
        first_ = false;
        put(value);
        return *this;
    }

  private:
    template <class Value>
    void put(const Value& value) {
        out_ << value;
    }

    void put(const std::optional<double>& value) {
        if (value) out_ << *value;
    }

    void put(const Spread& spread) {
        out_ << spread.median << ',' << spread.p90 << ',' << spread.max;
    }

    void put(const std::optional<Spread>& spread) {
        if (spread) {
            put(*spread);
        } else {
            out_ << ",,";
        }
    }

    std::ostream& out_;
    bool first_ = true;
};

}  // namespace poolhall::lab
