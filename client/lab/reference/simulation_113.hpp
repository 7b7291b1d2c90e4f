#pragma once

#include <memory>
#include <vector>

/// What the two compilations of the simulation say to each other: numbers only, since the types of
/// either mean nothing to the other.
namespace poolhall_reference {

/// A number of 113 bits as the double nearest to it and what that leaves, rounded to a double.
struct Number {
    double value = 0;
    double rest = 0;
};

/// A scene or a trace, field by field in the order of their lists (fields.hpp).
using Tape = std::vector<Number>;

/// Simulates shots in 113 bits; keeps its memory.
class Simulation {
  public:
    Simulation();
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// `sample_hz` as in poolhall::Simulator. The trace's tape is overwritten.
    void simulate(const Tape& scene, double sample_hz, Tape& trace);

  private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

}  // namespace poolhall_reference
