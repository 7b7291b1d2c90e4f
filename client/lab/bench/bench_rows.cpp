#include "client/lab/bench/bench_rows.hpp"

#include "client/lab/corpora/bench_scenes.hpp"
#include "client/lab/corpora/random.hpp"
#include "client/lab/run/bench_clock.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace poolhall::lab {

namespace {

// Measured on one 2-core machine, user CPU time; faster ends of the ranges. Other machines, other
// ratios.
constexpr const char* kPooltool = "pooltool 0.6-dev";
constexpr const char* kFastFiz = "FastFiz";
constexpr const char* kPrototype = "event prototype";

/// What the shots of some scenes add up to.
struct Tally {
    double events = 0;
    double ball_steps = 0;
    bool right = true;  ///< every kernel gives the same trace, and all came to rest
};

Tally tally(std::span<const Scene> scenes) {
    Tally sum;
    Simulator simulator;
    ShotTrace trace;
    ShotTrace other;
    for (const Scene& scene : scenes) {
        simulator.simulate(scene, 0, trace);
        sum.right = sum.right && trace.outcome == Outcome::kRest &&
                    simulator.simulate_by("everything", scene, 0, other) &&
                    other.hash == trace.hash && other.events == trace.events;
        sum.events += static_cast<double>(trace.events.size());
        sum.ball_steps += static_cast<double>(trace.ticks * scene.balls.size());
    }
    return sum;
}

/// Of all the scenes once.
Cost cost_of(std::span<const Scene> scenes, Simulator simulator = {}) {
    ShotTrace trace;
    return measure([&] {
        for (const Scene& scene : scenes)
            simulator.simulate(scene, 0, trace);
    });
}

std::string words(const Tally& sum) {
    return sum.right ? "every kernel gives the same trace, to rest"
                     : "kernels differ, or a shot does not end";
}

/// The unit of a cost, and how much of it a ns is.
struct Unit {
    double per_ns = 1;
    std::string name;
};

/// A row of a cost a piece.
BenchRow row(std::string name, const Cost& cost, double pieces, Unit unit, const Tally& sum) {
    BenchRow result{std::move(name), cost.ns / pieces * unit.per_ns, std::move(unit.name),
                    words(sum), !sum.right};
    if (cost.instructions) result.instructions = *cost.instructions / pieces;
    return result;
}

std::vector<BenchRow> two_ball_rows(const std::string& name, const std::vector<Scene>& shots,
                                    std::vector<Reference> rates, std::vector<Reference> events) {
    const Tally sum = tally(shots);
    const Cost cost = cost_of(shots);
    const auto count = static_cast<double>(shots.size());
    BenchRow rate = row(name + "_shot", cost, count, {1, "shots/s"}, sum);
    rate.value = 1e9 / rate.value;
    rate.references = std::move(rates);
    BenchRow event = row(name + "_event", cost, sum.events, {1, "ns/event"}, sum);
    event.references = std::move(events);
    return {rate, event};
}

std::vector<BenchRow> two_balls() {
    return two_ball_rows("two_ball", two_ball_shots(200), {{kPooltool, 237}, {kPrototype, 370000}},
                         {{kPrototype, 220}});
}

/// FastFiz has no table without pockets.
std::vector<BenchRow> two_balls_and_mouths() {
    std::vector<Scene> shots = two_ball_shots(200);
    for (Scene& shot : shots)
        shot.table.pockets = PocketModel::kPool;
    return two_ball_rows("two_ball_pool_table", shots, {{kFastFiz, 71000}}, {{kFastFiz, 1300}});
}

/// Shots from one position whose aims and speeds lie close together.
std::vector<BenchRow> many_shots() {
    const Scene position = two_ball_shots(1)[0];
    std::vector<Strike> strikes;
    std::vector<Scene> scenes;
    for (int i = 0; i < 200; ++i) {
        Scene scene = position;
        const Vec2 aim = scene.strike->direction;
        scene.strike->direction = aim + (1e-4 * i) * Vec2{-aim.y, aim.x};
        scene.strike->speed += 0.01 * (i % 7);
        strikes.push_back(*scene.strike);
        scenes.push_back(scene);
    }
    const Tally sum = tally(scenes);
    std::vector<ShotTrace> traces(strikes.size());
    Simulator simulator;
    const Cost together = measure([&] { simulator.simulate_many(position, strikes, 0, traces); });
    const auto count = static_cast<double>(strikes.size());
    return {row("one_by_one", cost_of(scenes), count, {1, "ns/shot"}, sum),
            row("simulate_many", together, count, {1, "ns/shot"}, sum)};
}

std::vector<BenchRow> break_rows(const std::string& name, const Scene& scene,
                                 std::vector<Reference> shots, std::vector<Reference> events) {
    const std::array scenes{scene};
    const Tally sum = tally(scenes);
    const Cost cost = cost_of(scenes);
    BenchRow shot = row(name, cost, 1, {1e-3, "us/shot"}, sum);
    shot.references = std::move(shots);
    shot.check += ", " + std::to_string(static_cast<int>(sum.events)) + " events";
    BenchRow event = row(name + "_event", cost, sum.events, {1, "ns/event"}, sum);
    event.references = std::move(events);
    return {shot, event};
}

std::vector<BenchRow> nine_balls() {
    return break_rows("nine_ball_break", nine_ball_break(), {{kPooltool, 50000}, {kPrototype, 43}},
                      {{kPrototype, 660}});
}

std::vector<BenchRow> fifteen_balls() {
    return break_rows("fifteen_ball_break", fifteen_ball_break(1e-4), {{kPooltool, 100000}}, {});
}

std::vector<BenchRow> mouths() {
    Scene scene = fifteen_ball_break(1e-4);
    scene.table.pockets = PocketModel::kPool;
    return break_rows("pool_table_break", scene, {{kPooltool, 100000}, {kFastFiz, 1129}},
                      {{kFastFiz, 18000}});
}

std::vector<BenchRow> steps() {
    std::vector<BenchRow> rows;
    for (const auto& [kind, hz] : {std::pair{SolverKind::kEuler, 30.0},
                                   {SolverKind::kSemiImplicit, 30.0},
                                   {SolverKind::kSemiImplicit, 120.0},
                                   {SolverKind::kExactArc, 30.0}}) {
        std::array scenes{fifteen_ball_break(1e-4)};
        scenes[0].solver = {kind, hz};
        const Tally sum = tally(scenes);
        const Cost cost = cost_of(scenes);
        const std::string solver =
            std::string(name(kind)) + "_" + std::to_string(static_cast<int>(hz));
        rows.push_back(row("ball_step_" + solver, cost, sum.ball_steps, {1, "ns/ball-step"}, sum));
        rows.back().references = {{"stepping prototype", 17}};
        rows.push_back(row("break_" + solver, cost, 1, {1e-3, "us/shot"}, sum));
    }
    return rows;
}

/// What an event costs as balls grow and the table with them.
std::vector<BenchRow> crowds() {
    std::vector<BenchRow> rows;
    double log2 = 1;
    for (std::size_t count = 2; count <= 256; count *= 2, ++log2) {
        const std::array scenes{crowd(count)};
        const Tally sum = tally(scenes);
        const Cost cost = cost_of(scenes);
        const std::string name = "crowd_of_" + std::to_string(count);
        rows.push_back(row(name, cost, sum.events, {1, "ns/event"}, sum));
        rows.back().check += ", " + std::to_string(static_cast<int>(sum.events)) + " events";
        rows.push_back(row(name + "_by_log2", cost, sum.events * log2, {1, "ns/event/log2"}, sum));
    }
    return rows;
}

/// The two ways in which the event solver searches: which is cheaper changes at kManyBalls.
std::vector<BenchRow> ways_to_search() {
    std::vector<BenchRow> rows;
    for (const std::size_t count : {8U, 16U, 20U, 24U, 32U, 64U, 256U}) {
        const std::array scenes{crowd(count)};
        Tally sum = tally(scenes);
        for (const auto& [way, many] :
             {std::pair{"looked_through", count + 1}, std::pair{"sifted", count}}) {
            Simulator simulator(many);
            ShotTrace trace;
            simulator.simulate(scenes[0], 0, trace);
            sum.right = sum.right && trace.hash == simulate(scenes[0]).hash;
            rows.push_back(row("crowd_of_" + std::to_string(count) + "_" + way,
                               cost_of(scenes, std::move(simulator)), sum.events, {1, "ns/event"},
                               sum));
        }
    }
    return rows;
}

/// Wrong verdicts, hit or miss, within an ulp of a graze.
std::vector<BenchRow> verdicts() {
    std::vector<BenchRow> rows;
    Simulator simulator;
    ShotTrace trace;
    for (const SolverKind kind : {SolverKind::kEuler, SolverKind::kExactArc, SolverKind::kEvent}) {
        Random random(3);
        BenchRow wrong{"wrong_graze_verdicts_" + std::string(name(kind)), 0, "of 2000",
                       "hit an ulp below two radii, miss an ulp above"};
        for (int i = 0; i < 2000; ++i) {
            const int ulps = i % 2 == 0 ? -1 : 1;
            Scene scene = graze(ulps, i / 2 % 4, random.uniform(0.1, 10));
            scene.solver.kind = kind;
            simulator.simulate(scene, 0, trace);
            wrong.value += trace.events.empty() == (ulps < 0) ? 1 : 0;
        }
        wrong.wrong = wrong.value > 0;
        rows.push_back(wrong);
    }
    return rows;
}

/// The most events of any of the scenes.
BenchRow most_events(std::string name, const std::vector<Scene>& scenes, double limit,
                     Reference reference) {
    BenchRow most{std::move(name), 0, "events", "all come to rest, none over the limit"};
    Simulator simulator;
    ShotTrace trace;
    for (const Scene& scene : scenes) {
        simulator.simulate(scene, 0, trace);
        most.value = std::max(most.value, static_cast<double>(trace.events.size()));
        most.wrong = most.wrong || trace.outcome != Outcome::kRest;
    }
    most.wrong = most.wrong || most.value > limit;
    most.references = {std::move(reference)};
    return most;
}

std::vector<BenchRow> event_counts() {
    std::vector<Scene> breaks{fifteen_ball_break(0)};
    constexpr double kFourthRootOfTen = 1.778279410038923;
    double gap = 1e-12;
    for (int i = 0; i <= 36; ++i, gap *= kFourthRootOfTen)
        breaks.push_back(fifteen_ball_break(gap));
    std::vector<Scene> chases;
    for (const double between : {0.0, 1e-12, 1e-9, 1e-6, 1e-4}) {
        for (const double surplus : {1e-12, 1e-9, 1e-6, 1e-4, 1e-2})
            chases.push_back(slow_chase(between, surplus));
    }
    return {most_events("most_events_of_a_break", breaks, 500, {kPrototype, 3771}),
            most_events("most_events_of_a_slow_chase", chases, 100, {kPooltool, 4590})};
}

}  // namespace

const std::vector<BenchGroup>& bench_groups() {
    static const std::vector<BenchGroup> groups{
        {"two_balls", two_balls},
        {"two_balls_and_mouths", two_balls_and_mouths},
        {"many_shots", many_shots},
        {"nine_balls", nine_balls},
        {"fifteen_balls", fifteen_balls},
        {"mouths", mouths},
        {"steps", steps},
        {"crowds", crowds},
        {"ways_to_search", ways_to_search},
        {"verdicts", verdicts},
        {"event_counts", event_counts},
    };
    return groups;
}

}  // namespace poolhall::lab
