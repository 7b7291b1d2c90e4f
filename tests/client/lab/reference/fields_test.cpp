// The tape on which scenes go to the reference.

#include "client/lab/reference/fields.hpp"

#include "tests/shared/scene_leaves.hpp"

#include <gtest/gtest.h>

namespace poolhall::lab {
namespace {

/// Names stay behind.
Scene without_names(Scene scene) {
    scene.id.clear();
    for (SceneBall& ball : scene.balls)
        ball.id.clear();
    for (PocketCircle& circle : scene.table.circles)
        circle.id.clear();
    return scene;
}

TEST(Tape, CarriesEveryFieldOfASceneButNames) {
    testing::for_each_changed_leaf([](const std::string& pointer, const Scene& scene) {
        poolhall_reference::Tape tape;
        TapeWriter{tape}(scene);
        Scene read;
        TapeReader{tape, TapeReader::Part::kSum}(read);
        EXPECT_EQ(without_names(scene), read) << pointer;
    });
}

}  // namespace
}  // namespace poolhall::lab
