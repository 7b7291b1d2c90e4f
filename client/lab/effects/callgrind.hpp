#pragma once

#include "shared/physics/scene/scene.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poolhall::lab {

/// Counts instructions by valgrind's callgrind, which needs no counter of the processor's and finds
/// the same number every time; some fifty times slower than they run.
class Callgrind {
  public:
    /// `lab`: the poolhall-lab whose `simulate` is counted.
    explicit Callgrind(std::filesystem::path lab) : lab_(std::move(lab)) {}

    /// Of simulating the shots once each by their own solvers, in the same memory; reading and
    /// writing them aside. Nothing once fault() says something, or after Ctrl-C.
    [[nodiscard]] std::optional<double> instructions_of(const std::vector<Scene>& shots);

    /// Why instructions cannot be counted, in a sentence without a full stop.
    [[nodiscard]] const std::optional<std::string>& fault() const { return fault_; }

  private:
    void run(const std::filesystem::path& folder);

    std::filesystem::path lab_;
    std::optional<std::string> fault_;
};

}  // namespace poolhall::lab
