#include "client/lab/reference/simulation_113.hpp"

#include "client/lab/reference/fields.hpp"
#include "shared/physics/solvers/event.hpp"
#include "shared/physics/solvers/shot_run.hpp"
#include "shared/physics/solvers/with_kernel.hpp"

namespace poolhall_reference {

struct Simulation::Memory {
    poolhall::Workspace workspace;
    poolhall::EventMemory event;
    poolhall::Scene scene;
    poolhall::ShotTrace trace;
};

Simulation::Simulation() : memory_(std::make_unique<Memory>()) {}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::simulate(const Tape& scene, double sample_hz, Tape& trace) {
    using poolhall::lab::TapeReader;
    TapeReader{scene, TapeReader::Part::kSum}(memory_->scene);
    poolhall::ShotRun run(memory_->scene, sample_hz, memory_->workspace, memory_->trace);
    // One kernel suffices: it covers every scene, and all that cover one give the same.
    const poolhall::Everything effects(
        poolhall::KernelScene(memory_->scene, memory_->workspace.cushions));
    poolhall::EventSolver<poolhall::Everything>(effects, run, memory_->event).solve();
    poolhall::lab::TapeWriter{trace}(memory_->trace);
}

}  // namespace poolhall_reference
