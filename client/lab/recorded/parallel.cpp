#include "client/lab/recorded/parallel.hpp"

#include "client/lab/run/progress.hpp"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace poolhall::lab {

void in_parallel(std::size_t count, std::size_t threads,
                 const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    const auto go = [&] {
        while (!Interruption::asked_for()) {
            const std::size_t mine = next++;
            if (mine >= count) return;
            work(mine);
        }
    };
    std::vector<std::thread> others(std::min(threads, count) - (count > 0 ? 1 : 0));
    for (std::thread& other : others)
        other = std::thread(go);
    go();
    for (std::thread& other : others)
        other.join();
}

}  // namespace poolhall::lab
