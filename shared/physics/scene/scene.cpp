#include "shared/physics/scene/scene.hpp"

namespace poolhall {

std::optional<BallIndex> find_ball(const Scene& scene, std::string_view id) {
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        if (scene.balls[i].id == id) return BallIndex{static_cast<std::uint16_t>(i)};
    }
    return std::nullopt;
}

}  // namespace poolhall
