#pragma once

#include <string>

// Numbers in words, as the lab and the table show them.
namespace poolhall::compare {

/// As printf() of that one number writes it, in at most 63 bytes.
[[nodiscard]] std::string formatted(const char* format, double value);

/// "12.3 µs".
[[nodiscard]] std::string text_of_cost(double cpu_ns);

/// "12.35 mm".
[[nodiscard]] std::string text_of_distance(double metres);

}  // namespace poolhall::compare
