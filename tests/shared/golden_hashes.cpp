// Prints `name hash` for each corpus of shots. tests/golden/hashes.txt holds what every compiler,
// optimisation level and processor must print.

#include "client/lab/corpora/corpora.hpp"
#include "shared/physics/scene/trace.hpp"

#include <cstdio>

int main() {
    for (const poolhall::lab::Corpus& corpus : poolhall::lab::corpora()) {
        std::printf("%.*s %s\n", static_cast<int>(corpus.name.size()), corpus.name.data(),
                    poolhall::to_hex(poolhall::lab::hash_of(corpus)).c_str());
    }
}
