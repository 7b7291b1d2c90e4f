#pragma once

#include "shared/physics/effects/prospect.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poolhall {

/// Of the balls that do not rest when the shot begins.
struct Start {
    std::size_t movers = 0;
    std::size_t a_mover = 0;
    bool off_cloth = false;  ///< a ball is in the air, or driven into the slate
    bool side_spin = false;
    Real energy = 0;  ///< J
};

[[nodiscard]] inline bool is_at_rest(const MovingBall& ball) {
    const auto bits = [](Real x) { return std::bit_cast<std::uint64_t>(x); };
    const std::uint64_t any = bits(ball.v.x) | bits(ball.v.y) | bits(ball.w.x) | bits(ball.w.y) |
                              bits(ball.w.z) | bits(ball.height) | bits(ball.climb);
    // But for signs of zeros.
    return any << 1U == 0;
}

/// The memory of both functions below, of each ball.
struct ReachMemory {
    struct Reached {
        Real spent = kInfinity;  ///< at least so much way times mass until it moves, kg m
        bool done = false;       ///< whom it can hit has been noted
    };

    struct Seen {
        Vec2 r;      ///< m
        Vec2 v;      ///< m/s
        Real t = 0;  ///< s
        bool moves = false;
    };

    std::vector<Reached> reached;
    std::vector<Seen> last;
};

/// Bounds, before the shot is simulated, where balls get that stay on the cloth: sets `reach`,
/// `meets` and `rails`, and `reach_is_bounded` where it could. One ball that meets nothing stays in
/// free_path(). Otherwise energy, which never rises, bounds the way: together balls do no more than
/// way_for_energy() allows, and one that rests moves only after another has come to it, with what
/// is left (`reach_is_by_energy`). Nothing is bounded that is far too fast for it.
void bound_reach(const Scene& scene, std::span<const MovingBall> balls, const Start& start,
                 ReachMemory& memory, Prospect& prospect);

/// Whether a shot whose reach is by energy stayed within, and met nobody unless `meets`. What is
/// said of energy is true of impacts and of free ways, not of what solvers do besides: steps, the
/// least separation of pressed balls, slides that contacts keep up. But nothing that was left out
/// could be met from within: so the trace itself completes the proof.
[[nodiscard]] bool stayed_within(const Prospect& prospect, const Scene& scene,
                                 const ShotTrace& trace, ReachMemory& memory);

}  // namespace poolhall
