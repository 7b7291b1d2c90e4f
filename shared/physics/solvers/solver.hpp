#pragma once

#include "shared/physics/scene/scene.hpp"
#include "shared/physics/solvers/shot_run.hpp"

#include <cstddef>
#include <memory>
#include <optional>

namespace poolhall {

/// What one solver keeps from shot to shot: of a type of its own, made at its first shot.
class SolverMemory {
  public:
    /// Always asked for with the same type.
    template <class T>
    [[nodiscard]] T& as() {
        if (!held_) held_ = std::make_unique<Holder<T>>();
        return static_cast<Holder<T>&>(*held_).value;
    }

  private:
    struct Held {
        Held() = default;
        Held(const Held&) = delete;
        Held& operator=(const Held&) = delete;
        virtual ~Held() = default;
    };

    template <class T>
    struct Holder final : Held {
        T value;
    };

    std::unique_ptr<Held> held_;
};

/// A solver as simulate(), check() and all programs know it. solvers.cpp lists them.
struct Solver {
    SolverKind kind = SolverKind::kEuler;
    bool has_ticks = true;  ///< false: SolverSpec::hz is not used
    /// Why it cannot do what a scene asks for.
    std::optional<SceneError> (*refusal)(const Scene& scene) = nullptr;
    /// Simulates the shot with the kernel at that place in KernelList, which covers the scene.
    void (*run)(std::size_t kernel, ShotRun& shot, SolverMemory& memory) = nullptr;
};

}  // namespace poolhall
