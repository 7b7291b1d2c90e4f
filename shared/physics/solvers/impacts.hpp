#pragma once

#include "shared/physics/motion/cloth.hpp"
#include "shared/physics/search/table_hooks.hpp"
#include "shared/physics/solvers/shot_run.hpp"

#include <vector>

namespace poolhall {

/// Takes the balls that are above the rails when they get there off the table.
template <class Set>
void lose_balls_over_rails(const Set& set, ShotRun& run, Real t) {
    if constexpr (Set::template kHook<hooks::Flight>) {
        const auto& flight = set.template hook<hooks::Flight>();
        std::vector<MovingBall>& balls = run.balls();
        for (const Contact& contact : run.workspace().contacts) {
            if (contact.kind != Contact::Kind::kRail || !flight.clears_rail(balls[contact.a]))
                continue;
            run.lose(t, contact.a);
        }
    }
}

template <class Set>
void drop_contacts_of_lost_balls(ShotRun& run) {
    if constexpr (Set::template kHook<hooks::Flight>) {
        const std::vector<MovingBall>& balls = run.balls();
        std::erase_if(run.workspace().contacts, [&](const Contact& contact) {
            return !in_play(balls[contact.a]) || !in_play(balls[contact.b]);
        });
    }
}

/// Places round; at a straight rail the right coordinate is known, and a million bounces stay
/// exact.
template <class Set>
void snap_to_rails(const Set& set, ShotRun& run) {
    if constexpr (Set::template kHook<hooks::StraightRails>) {
        const auto& rails = set.template hook<hooks::StraightRails>();
        // A kernel that knows them may simulate a table that has mouths instead.
        if (!rails.is_there()) return;
        for (const Contact& contact : run.workspace().contacts) {
            if (contact.kind != Contact::Kind::kRail) continue;
            MovingBall& ball = run.balls()[contact.a];
            const Vec2 edge = rails.edge(ball.reach);
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
/// records them. Of balls that are lost over a rail no contact is left. False if they do not
/// settle.
template <class Set>
bool resolve_contacts(const Set& set, const Cloth<Set>& cloth, ShotRun& run, Real t) {
    Workspace& work = run.workspace();
    std::vector<MovingBall>& balls = run.balls();
    drop_contacts_of_lost_balls<Set>(run);
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
