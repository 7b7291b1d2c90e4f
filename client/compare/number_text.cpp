#include "client/compare/number_text.hpp"

#include <array>
#include <cstdio>

namespace poolhall::compare {

std::string formatted(const char* format, double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

std::string text_of_cost(double cpu_ns) {
    return formatted(cpu_ns < 1e6 ? "%.3g \xC2\xB5s" : "%.0f \xC2\xB5s", cpu_ns / 1e3);
}

std::string text_of_distance(double metres) {
    return formatted("%.4g mm", metres * 1e3);
}

}  // namespace poolhall::compare
