#pragma once

#include "shared/physics/scene/scene.hpp"

#include <string>
#include <vector>

// The models of impacts that measurements choose between.
namespace poolhall::lab {

struct BallModel {
    std::string name;  ///< "e 0.95, Alciatore's law"
    BallBallSpec spec;
};

struct NoseModel {
    std::string name;  ///< "Mathavan, e 0.98, mu 0.14"
    RailSpec rail;
};

[[nodiscard]] BallBallSpec with_friction(double e, double mu);
/// Friction that falls with the speed of the slip (FrictionBySpeed).
[[nodiscard]] BallBallSpec with_alciatores_law(double e);

[[nodiscard]] std::vector<BallModel> ball_models();
/// Those of them that can throw a ball.
[[nodiscard]] std::vector<BallModel> throwing_models();
/// For the rails of a snooker table.
[[nodiscard]] std::vector<NoseModel> snooker_noses();
/// For the rails of a pool table.
[[nodiscard]] std::vector<NoseModel> pool_noses();
/// For the rails of a carom table with balls of 61.5 mm.
[[nodiscard]] std::vector<NoseModel> carom_noses();

template <class Model>
[[nodiscard]] std::vector<std::string> names_of(const std::vector<Model>& models) {
    std::vector<std::string> names;
    for (const Model& model : models)
        names.push_back(model.name);
    return names;
}

}  // namespace poolhall::lab
