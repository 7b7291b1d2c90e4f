#include "protocol/wire/scene_fields.hpp"

#include "protocol/tree.hpp"
#include "tests/shared/scene_leaves.hpp"

#include <gtest/gtest.h>

namespace poolhall::protocol {
namespace {

class SceneFields : public ::testing::TestWithParam<Encoding> {};

INSTANTIATE_TEST_SUITE_P(Encodings, SceneFields,
                         ::testing::Values(Encoding::kJson, Encoding::kCbor), [](const auto& test) {
                             return test.param == Encoding::kJson ? "Json" : "Cbor";
                         });

TEST_P(SceneFields, EachSurvivesByItself) {
    std::size_t count = 0;
    poolhall::testing::for_each_changed_leaf([&](const std::string& pointer, const Scene& scene) {
        ++count;
        const std::string bytes =
            write_tree(wire::SceneCodec{}.write(scene, GetParam()), GetParam());
        const auto tree = parse_tree(bytes, GetParam());
        ASSERT_TRUE(tree.ok()) << pointer;
        wire::Reading reading;
        Scene read;
        ASSERT_TRUE(wire::SceneCodec{}.read(wire::Cursor(*tree, reading), read))
            << pointer << ": " << reading.error->pointer << " " << reading.error->reason;
        EXPECT_EQ(scene, read) << pointer;
    });
    EXPECT_GT(count, 60U);
}

}  // namespace
}  // namespace poolhall::protocol
