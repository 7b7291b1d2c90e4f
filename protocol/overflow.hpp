#pragma once

#include <string>
#include <string_view>
#include <vector>

// JSON numbers beyond the largest double, at which nlohmann's parser gives up.
namespace poolhall::protocol {

/// The id of the parser's error.
inline constexpr int kNumberOverflow = 406;

/// A JSON text whose numbers beyond the largest double are null, and which nulls are such numbers.
struct Restated {
    std::string text;
    std::vector<bool> lost;  ///< for each null, in order
};

/// Needs a text that was read without a fault up to such a number.
[[nodiscard]] Restated restate(std::string_view json);

}  // namespace poolhall::protocol
