#include "shared/analysis/agreement.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

namespace poolhall::analysis {

namespace {

/// The places of each ball's events.
std::vector<std::vector<std::size_t>> events_by_ball(const ShotTrace& trace) {
    std::vector<std::vector<std::size_t>> places(trace.balls.size());
    for (std::size_t place = 0; place < trace.events.size(); ++place) {
        const ShotEvent& event = trace.events[place];
        for (std::size_t i = 0; i < event.ball_count; ++i)
            places[event.balls[i].value].push_back(place);
    }
    return places;
}

/// What each ball of the other trace does next.
class NextEvents {
  public:
    explicit NextEvents(const ShotTrace& trace)
        : trace_(trace), places_(events_by_ball(trace)), done_(trace.balls.size()) {}

    /// The ball's next event; nothing when it has no more.
    [[nodiscard]] std::optional<std::size_t> of(BallIndex ball) const {
        const auto& places = places_[ball.value];
        if (done_[ball.value] == places.size()) return std::nullopt;
        return places[done_[ball.value]];
    }

    /// The event that is next for all the balls of `event` and the same as it.
    [[nodiscard]] std::optional<std::size_t> same_as(const ShotEvent& event) const {
        const auto next = of(event.balls[0]);
        if (!next || !is_same_event(trace_.events[*next], event)) return std::nullopt;
        if (event.ball_count == 2 && of(event.balls[1]) != next) return std::nullopt;
        return next;
    }

    /// The earliest of what comes next for the balls of `event`.
    [[nodiscard]] std::optional<std::size_t> soonest(const ShotEvent& event) const {
        std::optional<std::size_t> soonest = of(event.balls[0]);
        if (event.ball_count == 1) return soonest;
        const auto second = of(event.balls[1]);
        return soonest && second ? std::min(soonest, second) : (soonest ? soonest : second);
    }

    /// The earliest of what comes next for any ball.
    [[nodiscard]] std::optional<std::size_t> soonest() const {
        std::optional<std::size_t> soonest;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const auto next = of(BallIndex{static_cast<std::uint16_t>(i)});
            if (next && (!soonest || *next < *soonest)) soonest = next;
        }
        return soonest;
    }

    void pass(const ShotEvent& event) {
        for (std::size_t i = 0; i < event.ball_count; ++i)
            ++done_[event.balls[i].value];
    }

  private:
    const ShotTrace& trace_;
    std::vector<std::vector<std::size_t>> places_;
    std::vector<std::size_t> done_;
};

/// To six digits.
std::string seconds(double t) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), t,
                                   std::chars_format::general, 6);
    return std::string(digits.data(), end.ptr) + " s";
}

/// Impacts of each pair, the lower place first.
std::map<std::pair<BallIndex, BallIndex>, std::ptrdiff_t> collisions_of(const ShotTrace& trace) {
    std::map<std::pair<BallIndex, BallIndex>, std::ptrdiff_t> counts;
    for (const ShotEvent& event : trace.events) {
        if (event.kind == EventKind::kBallBall)
            ++counts[std::minmax(event.balls[0], event.balls[1])];
    }
    return counts;
}

bool is_gone(const FinalBall& ball) {
    return ball.motion == Motion::kPocketed || ball.motion == Motion::kOffTable;
}

}  // namespace

bool is_same_event(const ShotEvent& a, const ShotEvent& b) {
    if (a.kind != b.kind || a.ball_count != b.ball_count) return false;
    if (a.kind == EventKind::kBallRail && a.rail != b.rail) return false;
    if (a.kind == EventKind::kBallPocket && a.pocket != b.pocket) return false;
    if (a.ball_count == 1) return a.balls[0] == b.balls[0];
    return std::minmax(a.balls[0], a.balls[1]) == std::minmax(b.balls[0], b.balls[1]);
}

bool is_impact(const ShotEvent& event) {
    return event.kind == EventKind::kBallBall || event.kind == EventKind::kBallRail;
}

Agreement agreement(const ShotTrace& reference, const ShotTrace& other) {
    Agreement result;
    NextEvents next(other);
    for (std::size_t place = 0; place < reference.events.size() && !result.lacking; ++place) {
        const ShotEvent& event = reference.events[place];
        if (const auto same = next.same_as(event)) {
            result.matching.emplace_back(place, *same);
            next.pass(event);
        } else {
            result.lacking = place;
            result.instead = next.soonest(event);
        }
    }
    if (!result.lacking) result.instead = next.soonest();
    result.horizon = result.lacking ? reference.events[*result.lacking].t : reference.duration;
    if (result.instead) result.horizon = std::min(result.horizon, other.events[*result.instead].t);
    return result;
}

std::string in_words(const Scene& scene, const ShotEvent& event) {
    const std::string& ball = scene.balls[event.balls[0].value].id;
    switch (event.kind) {
        case EventKind::kStrike:
            return ball + " is struck";
        case EventKind::kRollToRest:
            return ball + " comes to rest";
        case EventKind::kBallBall:
            return ball + " hits " + scene.balls[event.balls[1].value].id;
        case EventKind::kBallRail:
            return ball + " meets rail " + std::string(name(event.rail));
        case EventKind::kBallPocket:
            return ball + " drops into " + std::string(pocket_id(scene.table, event.pocket));
        case EventKind::kSlideToRoll:
            return ball + " begins to roll";
        case EventKind::kSpinToRest:
            return ball + " stops spinning";
        case EventKind::kBounce:
            return ball + " bounces on the slate";
        case EventKind::kOffTable:
            return ball + " leaves the table";
    }
    return "";
}

std::string first_difference(const Scene& scene, const Agreement& agreement,
                             const ShotTrace& reference, const ShotTrace& other,
                             const std::string& name_of_other) {
    const auto told = [&](const ShotEvent& event) {
        return "at " + seconds(event.t) + " " + in_words(scene, event);
    };
    if (agreement.complete()) return "";
    if (!agreement.lacking)
        return told(other.events[*agreement.instead]) + " in " + name_of_other + " only";
    std::string lacking =
        told(reference.events[*agreement.lacking]) + ", but not in " + name_of_other;
    if (!agreement.instead) return lacking;
    return lacking + ", where " + told(other.events[*agreement.instead]) + " instead";
}

std::vector<double> rest_distances(const ShotTrace& a, const ShotTrace& b) {
    std::vector<double> distances;
    for (std::size_t i = 0; i < a.balls.size(); ++i)
        distances.push_back(norm(a.balls[i].state.r - b.balls[i].state.r));
    return distances;
}

double farthest_at_rest(const ShotTrace& a, const ShotTrace& b) {
    const std::vector<double> distances = rest_distances(a, b);
    return *std::max_element(distances.begin(), distances.end());
}

bool is_same_verdict(const ShotTrace& a, const ShotTrace& b) {
    return std::equal(a.balls.begin(), a.balls.end(), b.balls.begin(), b.balls.end(),
                      [](const FinalBall& x, const FinalBall& y) {
                          if (!is_gone(x) && !is_gone(y)) return true;
                          return x.motion == y.motion &&
                                 (x.motion != Motion::kPocketed || x.pocket == y.pocket);
                      });
}

std::optional<BallIndex> first_pocketed(const ShotTrace& trace) {
    for (const ShotEvent& event : trace.events) {
        if (event.kind == EventKind::kBallPocket) return event.balls[0];
    }
    return std::nullopt;
}

CollisionCounts compare_collisions(const ShotTrace& reference, const ShotTrace& other) {
    auto surplus = collisions_of(other);
    for (const auto& [pair, count] : collisions_of(reference))
        surplus[pair] -= count;
    CollisionCounts counts;
    for (const auto& [pair, count] : surplus) {
        if (count < 0) counts.missed += static_cast<std::size_t>(-count);
        if (count > 0) counts.invented += static_cast<std::size_t>(count);
    }
    return counts;
}

}  // namespace poolhall::analysis
