#pragma once

namespace poolhall::lab {

/// What a command ends with; the program's exit status.
enum class Status : int {
    kGood = 0,
    kWrong = 1,          ///< an answer that was checked is wrong
    kBadInput = 2,       ///< or nothing could be read or written
    kInterrupted = 130,  ///< by Ctrl-C, as shells say it; what was finished is kept
};

}  // namespace poolhall::lab
