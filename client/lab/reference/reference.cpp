#include "client/lab/reference/reference.hpp"

#include "client/lab/reference/fields.hpp"
#include "client/lab/reference/simulation_113.hpp"
#include "shared/physics/simulate.hpp"

namespace poolhall::lab {

namespace {

void read(const poolhall_reference::Tape& tape, TapeReader::Part part, ShotTrace& trace) {
    TapeReader{tape, part}(trace);
    trace.solver = SolverKind::kEvent;
    trace.kernel = kernel_names().back();
    trace.hash = 0;
}

}  // namespace

struct ReferenceSimulator::Memory {
    poolhall_reference::Simulation simulation;
    poolhall_reference::Tape scene;
    poolhall_reference::Tape trace;
};

ReferenceSimulator::ReferenceSimulator() : memory_(std::make_unique<Memory>()) {}

ReferenceSimulator::~ReferenceSimulator() = default;
ReferenceSimulator::ReferenceSimulator(ReferenceSimulator&&) noexcept = default;
ReferenceSimulator& ReferenceSimulator::operator=(ReferenceSimulator&&) noexcept = default;

void ReferenceSimulator::simulate(const Scene& scene, double sample_hz, ShotTrace& trace) {
    TapeWriter{memory_->scene}(scene);
    memory_->simulation.simulate(memory_->scene, sample_hz, memory_->trace);
    read(memory_->trace, TapeReader::Part::kValue, trace);
    trace.hash = hash_of(trace);
}

void ReferenceSimulator::simulate(const Scene& scene, double sample_hz, ShotTrace& trace,
                                  ShotTrace& rest) {
    simulate(scene, sample_hz, trace);
    read(memory_->trace, TapeReader::Part::kRest, rest);
}

}  // namespace poolhall::lab
