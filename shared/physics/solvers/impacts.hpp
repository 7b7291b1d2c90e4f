#pragma once

#include "shared/physics/effects/airborne.hpp"
#include "shared/physics/effects/rails.hpp"
#include "shared/physics/motion/cloth.hpp"
#include "shared/physics/solvers/shot_run.hpp"

#include <vector>

namespace poolhall {

/// Balls that are above the rails when they get there are off the table: `lost(ball)` for each.
template <class Set, class Lost>
void lose_balls_over_rails(const Set& set, ShotRun& run, Real t, Lost lost) {
    if constexpr (Set::template kHas<Airborne>) {
        const Airborne& airborne = set.template effect<Airborne>();
        std::vector<MovingBall>& balls = run.balls();
        for (const Contact& contact : run.workspace().contacts) {
            if (contact.kind != Contact::Kind::kRail || !airborne.clears_rail(balls[contact.a]))
                continue;
            run.lose(t, contact.a);
            lost(contact.a);
        }
        std::erase_if(run.workspace().contacts, [&](const Contact& contact) {
            return !in_play(balls[contact.a]) || !in_play(balls[contact.b]);
        });
    }
}

/// Places round; at a straight rail the right coordinate is known, and a million bounces stay
/// exact.
template <class Set>
void snap_to_rails(const Set& set, ShotRun& run) {
    if constexpr (Set::template kHas<Rails>) {
        // A kernel that has them may simulate a table that has mouths instead.
        if (!Rails::called_for(run.scene())) return;
        for (const Contact& contact : run.workspace().contacts) {
            if (contact.kind != Contact::Kind::kRail) continue;
            MovingBall& ball = run.balls()[contact.a];
            const Vec2 edge = set.template effect<Rails>().edge(ball.radius);
            if (contact.normal.x != 0) ball.r.x = contact.normal.x * edge.x;
            if (contact.normal.y != 0) ball.r.y = contact.normal.y * edge.y;
        }
    }
}

/// Notes who has met whom. A ball that has met several at once has no partner: which of them it
/// were would hang on their order.
inline void note_partners(const std::vector<Contact>& contacts, std::vector<MovingBall>& balls) {
    for (const Contact& contact : contacts) {
        const bool is_pair =
            contact.kind == Contact::Kind::kBalls && stands_alone(contact, contacts);
        balls[contact.a].partner = is_pair ? contact.b : MovingBall::kNobody;
        balls[contact.b].partner = is_pair ? contact.a : MovingBall::kNobody;
    }
}

/// Lets the workspace's contacts, whose balls are as they are at t, happen as one group, and
/// records them. False if they do not settle. Of balls that are lost over a rail no contact is
/// left; `lost(ball)` is called for each.
template <class Set, class Lost>
bool resolve_contacts(const Set& set, const Cloth<Set>& cloth, ShotRun& run, Real t, Lost lost) {
    Workspace& work = run.workspace();
    std::vector<MovingBall>& balls = run.balls();
    lose_balls_over_rails(set, run, t, lost);
    snap_to_rails(set, run);
    work.before.clear();
    for (const Contact& contact : work.contacts) {
        work.before.push_back(balls[contact.a]);
        work.before.push_back(balls[contact.b]);
    }
    if (!work.contact_solver.resolve(work.contacts, balls)) return false;
    for (const Contact& contact : work.contacts) {
        cloth.settle(balls[contact.a]);
        if (contact.b != contact.a) cloth.settle(balls[contact.b]);
    }
    for (std::size_t k = 0; k < work.contacts.size(); ++k) {
        const Contact& contact = work.contacts[k];
        if (contact.kind == Contact::Kind::kRail) {
            run.record_rail(t, contact.a, contact.rail, work.before[2 * k]);
        } else {
            run.record_pair(t, contact.a, contact.b, work.before[2 * k], work.before[2 * k + 1]);
        }
    }
    note_partners(work.contacts, balls);
    return true;
}

}  // namespace poolhall
