#include "client/desktop/render/text.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

class TextTest : public testing::Test {
  protected:
    struct DestroyRenderer {
        void operator()(SDL_Renderer* owned) const { SDL_DestroyRenderer(owned); }
    };

    SurfacePtr surface{SDL_CreateRGBSurfaceWithFormat(0, 400, 100, 32, SDL_PIXELFORMAT_ARGB8888)};
    std::unique_ptr<SDL_Renderer, DestroyRenderer> renderer{
        SDL_CreateSoftwareRenderer(surface.get())};
    Canvas canvas{renderer.get()};
    Text text{canvas};
    TextStyle style{20, {255, 255, 255, 255}};
};

TEST_F(TextTest, LongTextIsCutToTheWidthAllowed) {
    const std::string name(400, 'W');
    for (const float room : {400.0F, 120.0F, 40.0F, 5.0F, 0.0F, -3.0F}) {
        EXPECT_LE(text.draw(name, style, {0, 50, Align::kLeft, room}), std::max(room, 0.0F) + 2)
            << room;
    }
}

TEST_F(TextTest, ShortTextIsNotCut) {
    EXPECT_NEAR(text.draw("Ada", style, {0, 50, Align::kLeft, 390}), text.width("Ada", style), 3);
}

TEST_F(TextTest, AnyBytesCanBeDrawn) {
    std::string every;
    for (int byte = 0; byte < 256; ++byte)
        every += static_cast<char>(byte);
    EXPECT_GT(text.draw(every, style, {0, 50}), 0);
    EXPECT_EQ(text.draw("", style, {0, 50}), 0);
    text.draw("\xE2\x80\x8B", style, {0, 50});  // of no width
}

TEST_F(TextTest, TheCacheIsBounded) {
    for (int i = 0; i < 600; ++i)
        text.draw(std::to_string(i), style, {0, 50});
    EXPECT_LE(text.cached_lines(), Text::kMaxLines);
    for (int size = 6; size < 100; ++size)
        EXPECT_GT(text.width("8", {static_cast<float>(size), style.colour}), 0);
}

}  // namespace
}  // namespace poolhall::client
