#pragma once

#include <ostream>
#include <string>

namespace poolhall::lab {

/// What a command ends with; the program's exit status.
enum class Status : int {
    kGood = 0,
    kWrong = 1,          ///< an answer that was checked is wrong
    kBadInput = 2,       ///< or nothing could be read or written
    kInterrupted = 130,  ///< by Ctrl-C, as shells say it; what was finished is kept
};

/// Says what is wrong in one line; `fault` has no full stop. Gives kBadInput.
[[nodiscard]] Status fail(std::ostream& error, const std::string& fault);

}  // namespace poolhall::lab
