#include "client/lab/reference/reference.hpp"

#include "client/lab/reference/fields.hpp"
#include "client/lab/reference/simulation_113.hpp"
#include "shared/math/double_double.hpp"
#include "shared/physics/simulate.hpp"

namespace poolhall::lab {

namespace {

using poolhall_reference::Tape;

/// The side of a table (m) at whose rails a ball of that radius (m) is at side/2 - radius, rounded
/// to a double.
poolhall_reference::Number side_for_rounded_edge(double side, double radius) {
    const DoubleDouble nose = two_sum(side / 2 - radius, radius);
    return {2 * nose.hi, 2 * nose.lo};
}

void read(const Tape& tape, TapeReader::Part part, ShotTrace& trace) {
    TapeReader{tape, part}(trace);
    trace.solver = SolverKind::kEvent;
    trace.kernel = kernel_names().back();
    trace.hash = 0;
}

}  // namespace

struct ReferenceSimulator::Memory {
    poolhall_reference::Simulation simulation;
    Tape scene;
    Tape trace;
};

ReferenceSimulator::ReferenceSimulator(RailPlaces rails)
    : rails_(rails), memory_(std::make_unique<Memory>()) {}

ReferenceSimulator::~ReferenceSimulator() = default;
ReferenceSimulator::ReferenceSimulator(ReferenceSimulator&&) noexcept = default;
ReferenceSimulator& ReferenceSimulator::operator=(ReferenceSimulator&&) noexcept = default;

void ReferenceSimulator::simulate(const Scene& scene, double sample_hz, ShotTrace& trace) {
    Tape& tape = memory_->scene;
    TapeWriter{tape}(scene);
    if (rails_ == RailPlaces::kRounded && scene.table.pockets != PocketModel::kPool) {
        // The first two fields are the table's sides.
        tape[0] = side_for_rounded_edge(scene.table.length, scene.ball.radius);
        tape[1] = side_for_rounded_edge(scene.table.width, scene.ball.radius);
    }
    memory_->simulation.simulate(tape, sample_hz, memory_->trace);
    read(memory_->trace, TapeReader::Part::kValue, trace);
    trace.hash = hash_of(trace);
}

void ReferenceSimulator::simulate(const Scene& scene, double sample_hz, ShotTrace& trace,
                                  ShotTrace& rest) {
    simulate(scene, sample_hz, trace);
    read(memory_->trace, TapeReader::Part::kRest, rest);
}

}  // namespace poolhall::lab
