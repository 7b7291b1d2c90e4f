#include "shared/physics/simulate.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/shared/invariants.hpp"

#include <cstdint>
#include <cstring>
#include <string>

namespace poolhall::fuzz {
namespace {

/// Numbers out of the fuzzer's bytes; zeros when they are used up.
class Bytes {
  public:
    explicit Bytes(std::string_view bytes) : left_(bytes) {}

    std::uint8_t byte() {
        if (left_.empty()) return 0;
        const auto first = static_cast<std::uint8_t>(left_.front());
        left_.remove_prefix(1);
        return first;
    }

    template <NamedEnum E>
    E any_of() {
        return kValues<E>[byte() % kCount<E>];
    }

    bool flag() { return (byte() & 1U) != 0; }

    /// From low to high in steps of 1/65535 of the way: nearly equal numbers come often.
    double between(double low, double high) {
        const auto fraction = static_cast<double>(byte() * 256 + byte()) / 65535;
        return low + fraction * (high - low);
    }

    /// Any double at all, as its bits.
    double any() {
        std::uint64_t bits = 0;
        for (int i = 0; i < 8; ++i)
            bits = bits << 8U | byte();
        double x = 0;
        static_assert(sizeof x == sizeof bits);
        std::memcpy(&x, &bits, sizeof x);
        return x;
    }

  private:
    std::string_view left_;
};

void choose_cloth(Bytes& bytes, Effects& effects) {
    if (bytes.flag()) effects.linear_drag = LinearDragSpec{bytes.between(0, 2), 0.0625};
    if (bytes.flag()) effects.sliding = SlidingSpec{bytes.between(0, 1)};
    if (bytes.flag()) effects.rolling = RollingSpec{bytes.between(0, 0.1)};
    if (bytes.flag()) effects.spin_decay = SpinDecaySpec{bytes.between(0, 0.1)};
    if (bytes.byte() % 8 == 0) effects.airborne = AirborneSpec{bytes.between(0, 1)};
}

void choose_impacts(Bytes& bytes, Effects& effects) {
    effects.ball_ball.model = bytes.any_of<BallBallModel>();
    effects.ball_ball.e = bytes.between(0, 1);
    effects.ball_ball.mu = bytes.between(0, 0.2);
    effects.rail.model = bytes.any_of<RailModel>();
    effects.rail.e = bytes.between(0, 1);
}

/// A ball on the table, or beside the one before it so that they touch or nearly do.
SceneBall choose_ball(Bytes& bytes, const Scene& scene) {
    SceneBall ball{std::to_string(scene.balls.size()), {}};
    const bool beside = bytes.flag() && !scene.balls.empty();
    ball.state.r = {bytes.between(-1.25, 1.25), bytes.between(-0.61, 0.61), 0};
    if (beside) {
        ball.state.r = scene.balls.back().state.r;
        const double gap = bytes.between(0, 1e-6);
        (bytes.flag() ? ball.state.r.x : ball.state.r.y) += 2 * scene.ball.radius + gap;
    }
    if (bytes.flag()) ball.state.v = {bytes.between(-10, 10), bytes.between(-10, 10), 0};
    if (bytes.flag())
        ball.state.w = {bytes.between(-200, 200), bytes.between(-200, 200),
                        bytes.between(-200, 200)};
    // Now and then a number of which nothing is known.
    if (bytes.byte() == 255) ball.state.v.x = bytes.any();
    if (bytes.byte() == 255) ball.state.r.y = bytes.any();
    return ball;
}

/// So slow that balls do not get far, and bounds leave out what nobody gets to.
void slow_down(Scene& scene) {
    constexpr double kSlow = 0.02;
    for (SceneBall& ball : scene.balls) {
        ball.state.v = kSlow * ball.state.v;
        ball.state.w = kSlow * ball.state.w;
    }
}

Scene choose_scene(Bytes& bytes) {
    Scene scene;
    scene.solver.kind = bytes.any_of<SolverKind>();
    scene.table.rails = bytes.byte() % 8 != 0;
    scene.table.pockets = bytes.any_of<PocketModel>();
    if (scene.table.pockets == PocketModel::kCircles)
        scene.table.circles = {{"NE", {1.27, 0.635}, bytes.between(0.03, 0.2)}};
    choose_cloth(bytes, scene.effects);
    choose_impacts(bytes, scene.effects);
    for (int count = 1 + bytes.byte() % 7; count > 0; --count)
        scene.balls.push_back(choose_ball(bytes, scene));
    scene.limits = {5, 2000};
    if (bytes.flag()) slow_down(scene);
    return scene;
}

/// How far balls may overlap, m: what the solver promises; `overlap` promises nothing.
double tolerance_of(SolverKind solver) {
    return solver == SolverKind::kOverlap ? 1 : 2 * kTouchTolerance;
}

}  // namespace

/// The bytes choose a scene. What check() lets pass is simulated, must keep the laws of
/// tests/shared/invariants.hpp, and comes out the same by the kernel of all effects, of which
/// nothing is ruled out.
void shot(std::string_view input) {
    Bytes bytes(input);
    const Scene scene = choose_scene(bytes);
    if (const auto error = check(scene))
        return require(!error->reason.empty(), "refused without a reason");
    const ShotTrace trace = simulate(scene, 30);
    const std::string broken =
        testing::broken_invariant(scene, trace, tolerance_of(scene.solver.kind));
    require(broken.empty(), broken.c_str());
    ShotTrace other;
    require(simulate_by("everything", scene, 30, other) && other.hash == trace.hash,
            "the kernels do not agree");
}

}  // namespace poolhall::fuzz
