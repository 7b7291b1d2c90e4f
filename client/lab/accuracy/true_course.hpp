#pragma once

#include "client/lab/ensembles/ensembles.hpp"
#include "client/lab/reference/reference.hpp"

#include <string_view>

namespace poolhall::lab {

/// What shots are measured against.
class TrueCourse {
  public:
    explicit TrueCourse(ReferenceKind kind) : kind_(kind) {}

    /// As Simulator::simulate(); the trace's numbers are the doubles nearest to the true ones.
    void simulate(const Scene& scene, double sample_hz, ShotTrace& trace);

    /// In words.
    [[nodiscard]] std::string_view name() const;

  private:
    ReferenceKind kind_;
    ReferenceSimulator reference_;
};

}  // namespace poolhall::lab
