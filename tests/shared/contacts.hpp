#pragma once

#include "shared/physics/contact/contact.hpp"

#include <vector>

namespace poolhall::testing {

/// Resolves contacts of elastic balls and of rails with restitution `e_rail`.
[[nodiscard]] inline bool resolve_contacts(const std::vector<Contact>& contacts, double e_rail,
                                           std::vector<MovingBall>& balls) {
    Scene scene;
    scene.balls.resize(balls.size());
    scene.effects.rail = {RailModel::kRestitution, e_rail};
    ContactSolver solver;
    solver.prepare(scene);
    return solver.resolve(contacts, balls);
}

}  // namespace poolhall::testing
