#pragma once

#include <cstddef>
#include <functional>

namespace poolhall::lab {

/// work(0), ..., work(count - 1), by so many threads, this one included; each takes the next that
/// nobody has. Ctrl-C (Interruption) lets those under way finish and begins no other. What `work`
/// writes must be its own, so that the number of threads does not show.
void in_parallel(std::size_t count, std::size_t threads,
                 const std::function<void(std::size_t)>& work);

}  // namespace poolhall::lab
