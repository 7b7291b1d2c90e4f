#include "client/desktop/view/ball_art.hpp"

#include <cmath>

namespace poolhall::client {
namespace {

// Finer differences between pixels cannot be seen, and would have resting balls painted again for
// rounding errors.
float to_quarter(float fraction) {
    return std::round(fraction * 4) / 4;
}

}  // namespace

void BallArt::draw(Canvas& canvas, std::size_t index, SDL_FPoint centre, const BallPose& pose) {
    if (pictures_.size() <= index) pictures_.resize(index + 1);
    Picture& picture = pictures_[index];
    const SDL_FPoint whole{std::floor(centre.x), std::floor(centre.y)};
    BallPose placed = pose;
    placed.fraction = {to_quarter(centre.x - whole.x), to_quarter(centre.y - whole.y)};
    if (picture.pose != placed) paint(canvas, placed, picture);
    if (!picture.texture) return;
    const auto side = static_cast<float>(picture.image.width);
    canvas.copy(picture.texture.get(), {whole.x - side / 2, whole.y - side / 2, side, side});
}

void BallArt::paint(Canvas& canvas, const BallPose& pose, Picture& picture) {
    const int old_side = picture.image.width;
    paint_ball(pose, picture.image);
    if (!picture.texture || picture.image.width != old_side) {
        picture.texture = canvas.texture_of(picture.image);
    } else {
        SDL_UpdateTexture(picture.texture.get(), nullptr, picture.image.pixels.data(),
                          picture.image.pitch());
    }
    picture.pose = pose;
}

}  // namespace poolhall::client
