#pragma once

#include "client/lab/reference/reference.hpp"
#include "shared/physics/simulate.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace poolhall::lab {

/// 50 decimal digits, by another library than what is tested.
using Exact = boost::multiprecision::cpp_bin_float_50;

/// How far off `actual` is, as a share of `expected`, or as it is where that is 0.
inline double error_of(const Exact& actual, const Exact& expected) {
    const Exact off = abs(actual - expected);
    return static_cast<double>(expected == 0 ? off : off / abs(expected));
}

/// A decimal of many digits.
inline Exact exact(const nlohmann::json& number) {
    return Exact(number.get<std::string>());
}

struct ExactVec {
    Exact x;
    Exact y;
};

inline double distance(const ExactVec& a, const ExactVec& b) {
    return static_cast<double>(sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)));
}

inline ExactVec exact_vector(const nlohmann::json& numbers) {
    return {exact(numbers.at(0)), exact(numbers.at(1))};
}

/// A shot in 113 bits, with all of them.
class ExactShot {
  public:
    explicit ExactShot(const Scene& scene, RailPlaces rails = RailPlaces::kRounded) {
        ReferenceSimulator(rails).simulate(scene, 0, trace_, rest_);
    }

    [[nodiscard]] const ShotTrace& trace() const { return trace_; }

    /// The events of a kind, as places in the trace.
    [[nodiscard]] std::vector<std::size_t> events(EventKind kind) const {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < trace_.events.size(); ++i) {
            if (trace_.events[i].kind == kind) found.push_back(i);
        }
        return found;
    }

    [[nodiscard]] Exact t(std::size_t event) const {
        return Exact(trace_.events[event].t) + rest_.events[event].t;
    }

    [[nodiscard]] ExactVec place_after(std::size_t event, std::size_t which = 0) const {
        return sum(trace_.events[event].after[which].r, rest_.events[event].after[which].r);
    }

    [[nodiscard]] ExactVec velocity_after(std::size_t event, std::size_t which = 0) const {
        return sum(trace_.events[event].after[which].v, rest_.events[event].after[which].v);
    }

    [[nodiscard]] ExactVec final_place(std::size_t ball) const {
        return sum(trace_.balls[ball].state.r, rest_.balls[ball].state.r);
    }

    /// The largest distance at which a ball ends from where it does in another trace, m.
    [[nodiscard]] double rest_error(const ShotTrace& other) const {
        double largest = 0;
        for (std::size_t i = 0; i < trace_.balls.size(); ++i) {
            const Vec3& r = other.balls[i].state.r;
            largest = std::max(largest, distance(final_place(i), {Exact(r.x), Exact(r.y)}));
        }
        return largest;
    }

  private:
    static ExactVec sum(const Vec3& value, const Vec3& rest) {
        return {Exact(value.x) + rest.x, Exact(value.y) + rest.y};
    }

    ShotTrace trace_;
    ShotTrace rest_;
};

}  // namespace poolhall::lab
