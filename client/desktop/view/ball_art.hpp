#pragma once

#include "client/desktop/render/canvas.hpp"
#include "client/desktop/view/ball_painter.hpp"

#include <optional>
#include <vector>

namespace poolhall::client {

/// Draws the balls. Each has a picture, painted anew only when the ball has rolled, moved between
/// pixels or changed size.
class BallArt {
  public:
    /// `centre` in pixels; `pose.fraction` is found from it. Balls are told apart by `index`.
    void draw(Canvas& canvas, std::size_t index, SDL_FPoint centre, const BallPose& pose);

    void reset() { pictures_.clear(); }

  private:
    struct Picture {
        std::optional<BallPose> pose;
        Image image;
        TexturePtr texture;
    };

    static void paint(Canvas& canvas, const BallPose& pose, Picture& picture);

    std::vector<Picture> pictures_;
};

}  // namespace poolhall::client
