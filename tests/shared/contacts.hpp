#pragma once

#include "shared/physics/contact/contact.hpp"

#include <vector>

namespace poolhall::testing {

/// Resolves contacts of elastic balls and of rails with restitution `e_rail`.
[[nodiscard]] inline bool resolve_contacts(const std::vector<Contact>& contacts, double e_rail,
                                           std::vector<MovingBall>& balls) {
    ImpactModels models;
    models.ball_ball = {BallBallModel::kElastic};
    models.rail = {RailModel::kRestitution, e_rail};
    models.unit_mass = BallSpec{}.mass;
    models.balls = balls.size();
    ContactSolver solver;
    solver.prepare(models);
    return solver.resolve(contacts, balls);
}

}  // namespace poolhall::testing
