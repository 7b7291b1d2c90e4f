#pragma once

#include "tests/shared/reference.hpp"
#include "tests/shared/solvers.hpp"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

// Shots of reference/quad_shots.json as scenes.
namespace poolhall::testing {

/// The double nearest to a number that may be written as a hex float or with many digits.
inline double number(const nlohmann::json& value) {
    return value.is_string() ? std::strtod(value.get<std::string>().c_str(), nullptr)
                             : value.get<double>();
}

/// The circles of the file's model, in its order of pockets.
inline std::vector<PocketCircle> circles(const Table& table) {
    const double x = table.length / 2;
    const double y = table.width / 2;
    return {{"SW", {-x, -y}, 0.06}, {"S", {0, -y}, 0.05}, {"SE", {x, -y}, 0.06},
            {"NW", {-x, y}, 0.06},  {"N", {0, y}, 0.05},  {"NE", {x, y}, 0.06}};
}

/// A shot of the file. Its numbers have their origin at the south-west corner; to move it loses no
/// bit of any of them.
inline Scene quad_scene(const nlohmann::json& model, const nlohmann::json& shot) {
    Scene scene;
    scene.table.length = model.at("table_w");
    scene.table.width = model.at("table_h");
    scene.table.pockets = PocketModel::kCircles;
    scene.table.circles = circles(scene.table);
    scene.ball.radius = model.at("R");
    scene.gravity = model.at("g");
    scene.effects = cloth_effects();
    scene.effects.sliding->mu = model.at("mu_s");
    scene.effects.rolling->mu = model.at("mu_r");
    scene.effects.ball_ball.e = model.at("e_ball");
    scene.effects.ball_ball.min_separation = model.at("min_separation_speed");
    scene.effects.rail.e = model.at("e_rail");
    scene.solver.kind = SolverKind::kEvent;
    for (const nlohmann::json& ball : shot.at("balls")) {
        const nlohmann::json& in = ball.at("in");
        SceneBall one{std::to_string(scene.balls.size()), {}};
        one.state.r = {number(in[0]) - scene.table.length / 2,
                       number(in[1]) - scene.table.width / 2, 0};
        one.state.v = {number(in[2]), number(in[3]), 0};
        one.state.w = {number(in[4]), number(in[5]), 0};
        scene.balls.push_back(one);
    }
    return scene;
}

}  // namespace poolhall::testing
