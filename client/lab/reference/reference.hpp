#pragma once

#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <memory>

namespace poolhall::lab {

/// Where straight, unbroken rails are met by balls of the scene's common radius.
enum class RailPlaces {
    kRounded,  ///< at |x| = length/2 - radius rounded to a double, as the scene's format says
    kExact,    ///< without that, to compare with other programs
};

/// Simulates shots by the event solver in numbers of 113 bits: what doubles are measured against.
///
/// The same sources of shared/, compiled a second time (CMakeLists.txt here says how), so that the
/// model is the same to the last branch and only the arithmetic differs. The scene's numbers are
/// its doubles, exactly; from the strike on all is 113 bits, and an event is the soonest in 113
/// bits.
///
/// What it is no reference for: balls that touch to within the last bit of a double, as in a rack
/// without gaps, since in 113 bits they are apart or overlap by that bit, and so it is another
/// rack; and Mathavan's rail, which is integrated in the same steps to the same tolerance, so that
/// the error of the integration is not seen.
///
/// Where events of a shot in doubles are compared with it: a ball whose spin is that of rolling to
/// the last bit of a double slides for some 1e-17 s first, which is an event; and what happens at
/// one instant, as two slides that began in the same impact end, may be told in another order.
///
/// The scene must have passed check() for the event solver; its `solver` is not looked at. One at a
/// time a thread. Memory is used again from shot to shot.
class ReferenceSimulator {
  public:
    explicit ReferenceSimulator(RailPlaces rails = RailPlaces::kRounded);
    ~ReferenceSimulator();
    ReferenceSimulator(ReferenceSimulator&&) noexcept;
    ReferenceSimulator& operator=(ReferenceSimulator&&) noexcept;

    /// As Simulator::simulate(). Every number of the trace is the double nearest to that of 113
    /// bits; `solver` is kEvent, `kernel` "everything", which gives the same as any other, and
    /// `hash` that of the rounded trace.
    void simulate(const Scene& scene, double sample_hz, ShotTrace& trace);

    /// The same, and in `rest` what rounding took away: a trace of the same shape, in which every
    /// real number x of `trace` has its x_exact - x, so that x and it together have 106 bits or
    /// more. Its other fields are those of `trace`, its hash is 0.
    void simulate(const Scene& scene, double sample_hz, ShotTrace& trace, ShotTrace& rest);

  private:
    struct Memory;

    RailPlaces rails_;
    std::unique_ptr<Memory> memory_;
};

}  // namespace poolhall::lab
