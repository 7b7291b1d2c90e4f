// The fuzz targets without a fuzzer: a fixed number of seeded mutations of their corpora.

#include "tests/fuzz/targets.hpp"
#include "tests/protocol/random_messages.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace poolhall::protocol {
namespace {

using testing::Random;

constexpr int kMutations = 20000;

struct Target {
    const char* name;
    void (*run)(std::string_view bytes);

    /// The test's name must not hold an address, which changes from run to run.
    friend void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }
};

class Mutations : public ::testing::TestWithParam<Target> {};

INSTANTIATE_TEST_SUITE_P(Targets, Mutations,
                         ::testing::Values(Target{"client_json", fuzz::client_json},
                                           Target{"client_cbor", fuzz::client_cbor},
                                           Target{"server_json", fuzz::server_json},
                                           Target{"server_cbor", fuzz::server_cbor},
                                           Target{"scene", fuzz::scene}),
                         [](const auto& target) { return std::string(target.param.name); });

std::vector<std::string> corpus(const std::string& name) {
    std::vector<std::filesystem::path> paths;
    const std::filesystem::path folder = POOLHALL_SOURCE_DIR "/tests/fuzz/corpus/" + name;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> seeds;
    for (const auto& path : paths) {
        std::ifstream file(path, std::ios::binary);
        seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return seeds;
}

/// What decoders have stumbled over elsewhere.
std::string_view awkward(Random& random) {
    using namespace std::string_view_literals;
    static constexpr std::array kPieces{"null"sv,
                                        "1e999"sv,
                                        "-0.0"sv,
                                        "[[[[[[[[["sv,
                                        "{}"sv,
                                        "\"0x1p-1\""sv,
                                        "\\u0000"sv,
                                        "\xFF"sv,
                                        "\x9B\xFF\xFF"sv,
                                        "\x7F\x7F\x7F"sv,
                                        "\xC1\xC1"sv,
                                        ","sv,
                                        "18446744073709551616"sv,
                                        "\0"sv,
                                        "\xFB\x7F\xF8"sv,
                                        "4294967296"sv};
    return kPieces[random.below(kPieces.size())];
}

std::string mutate(std::string bytes, const std::string& other, Random& random) {
    const std::size_t at = random.below(bytes.size() + 1);
    const std::size_t count = random.below(8);
    switch (random.below(6)) {
        case 0:
            return bytes.replace(at, count, awkward(random));
        case 1:
            return bytes.insert(at, bytes.substr(at, count));
        case 2:
            return bytes.erase(at, count);
        case 3:
            return bytes.substr(0, at) + other.substr(std::min(at, other.size()));
        case 4:
            return bytes.insert(at, other.substr(random.below(other.size() + 1), 40));
        default:
            break;
    }
    if (at < bytes.size()) bytes[at] = static_cast<char>(random.below(256));
    return bytes;
}

TEST_P(Mutations, AreReadOrRefused) {
    const std::vector<std::string> seeds = corpus(GetParam().name);
    ASSERT_FALSE(seeds.empty());
    for (const std::string& seed : seeds)
        GetParam().run(seed);
    Random random(5);
    for (int i = 0; i < kMutations; ++i) {
        std::string bytes = seeds[random.below(seeds.size())];
        for (std::size_t times = 1 + random.below(3); times > 0; --times)
            bytes = mutate(std::move(bytes), seeds[random.below(seeds.size())], random);
        GetParam().run(bytes);
    }
}

}  // namespace
}  // namespace poolhall::protocol
