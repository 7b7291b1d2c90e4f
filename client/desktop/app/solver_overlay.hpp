#pragma once

#include "client/compare/comparison.hpp"
#include "client/play/playback.hpp"
#include "client/play/view_state.hpp"
#include "shared/analysis/paths.hpp"

#include <cstddef>
#include <cstdint>
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace poolhall::client {

/// The shot that is shown, or was shown last, by other solvers than the one that decides it. They
/// run here, beside the window's thread, once a shot, and only while the overlay is on.
class SolverOverlay {
  public:
    /// From off to the first solvers, to other ones, and to off again.
    void cycle();
    /// What cycle() has come to: "Other solvers: event, euler 30 Hz, overlap 30 Hz".
    [[nodiscard]] std::string description() const;

    /// The shot that is shown now. One that is followed already changes nothing.
    void follow(const Shot& shot);
    /// Takes what has been computed since; true if there is something new to show.
    bool poll();

    /// Something is being computed.
    [[nodiscard]] bool pending() const { return running_.valid(); }

    /// The solvers of the overlay with their balls at `t` s; none while it is off or has nothing
    /// yet.
    [[nodiscard]] std::vector<SolverView> view(double t) const;

    /// Number of the shot that the overlay is of; nothing before one.
    [[nodiscard]] std::optional<std::uint32_t> shot() const { return shot_; }

  private:
    /// One solver's shot, ready to be drawn.
    struct Entry {
        SolverView view;                    ///< but for its balls
        std::vector<analysis::Path> paths;  ///< of the balls that move, without end
    };

    struct Entries {
        std::uint32_t shot = 0;
        std::vector<Entry> entries;  ///< in the order of the entrants
    };

    void start();
    [[nodiscard]] static std::vector<Entry> entries_of(const Scene& scene);
    [[nodiscard]] static Entry entry_of(const Scene& scene, const compare::Comparison& comparison,
                                        const compare::SolverRun& run);

    std::size_t chosen_ = 0;  ///< 0: off; else which of the sets, from 1
    std::optional<std::uint32_t> shot_;
    Scene scene_;  ///< of that shot; without a strike if that is not known
    std::future<Entries> running_;
    Entries done_;
};

}  // namespace poolhall::client
