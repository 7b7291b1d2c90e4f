#include "client/desktop/net/backoff.hpp"

#include <algorithm>

namespace poolhall::client {

std::chrono::milliseconds Backoff::next() {
    std::uniform_int_distribution<std::chrono::milliseconds::rep> pause(longest_.count() / 2,
                                                                        longest_.count());
    const std::chrono::milliseconds chosen{pause(random_)};
    longest_ = std::min(2 * longest_, kLongest);
    return chosen;
}

}  // namespace poolhall::client
