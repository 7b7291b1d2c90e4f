#include "client/lab/recorded/marks.hpp"

#include <algorithm>
#include <cmath>

namespace poolhall::lab {

namespace {

constexpr double kAfterContact = 0.25;  ///< s; enough samples to see where a ball goes on to
constexpr double kHardlyLater = 0.2;    ///< s; contacts that are nearer share a horizon
constexpr double kFrame = 0.02;         ///< s

/// Whether the middle one of three coordinates is the turn of a way at a rail's nose at +-edge.
bool turns_at(double before, double here, double after, double edge) {
    constexpr double kNear = 0.004;  // m
    const double side = here > 0 ? 1 : -1;
    const double in = side * (here - before);
    const double out = side * (after - here);
    // The turn itself falls between samples.
    const double step = 1.2 * std::max(std::abs(in), std::abs(out));
    return in > 0 && out <= 0 && std::abs(here) > edge - step - kNear;
}

/// When the ball meets rails, s.
std::vector<double> rail_times(const RecordedTrack& track) {
    constexpr double kSameHit = 0.03;  // s; in a corner both coordinates turn
    const Vec2 edge{kCaromLength / 2 - kRecordedBall.radius,
                    kCaromWidth / 2 - kRecordedBall.radius};
    std::vector<double> times;
    for (std::size_t i = 1; i + 1 < track.t.size(); ++i) {
        const Vec2 a = track.r[i - 1];
        const Vec2 b = track.r[i];
        const Vec2 c = track.r[i + 1];
        const bool turns = turns_at(a.x, b.x, c.x, edge.x) || turns_at(a.y, b.y, c.y, edge.y);
        if (turns && (times.empty() || track.t[i] - times.back() > kSameHit))
            times.push_back(track.t[i]);
    }
    return times;
}

/// Direction and speed of the straight way up to the first contact.
void mark_start(const RecordedTrack& track, double first_contact, ShotMarks& marks) {
    constexpr std::size_t kMostSamples = 15;
    std::size_t last = 1;
    while (last < kMostSamples && last + 1 < track.t.size() && track.t[last + 1] <= first_contact)
        ++last;
    marks.direction = normalized(track.r[last] - track.r[0]);
    // The cue ball may have lain still for a part of the first frame.
    const std::size_t to = std::min<std::size_t>(last, 3);
    const std::size_t from = to > 1 ? 1 : 0;
    marks.speed = norm(track.r[to] - track.r[from]) / (track.t[to] - track.t[from]);
}

}  // namespace

ShotMarks marks_of(const RecordedShot& shot) {
    ShotMarks marks;
    std::vector<double> contacts = rail_times(shot.tracks[shot.cue]);
    constexpr std::size_t kThird = 2;
    for (const RecordedTrack& track : shot.tracks)
        marks.end = std::max(marks.end, track.t.back());
    marks.third_rail = contacts.size() > kThird ? contacts[kThird] : marks.end;
    for (std::size_t i = 0; i < shot.tracks.size(); ++i) {
        if (i != shot.cue && shot.tracks[i].t.size() > 2)
            contacts.push_back(std::max(0.0, shot.tracks[i].t[1] - kFrame));
    }
    std::sort(contacts.begin(), contacts.end());
    mark_start(shot.tracks[shot.cue], contacts.empty() ? marks.end : contacts.front(), marks);
    for (const double contact : contacts) {
        const double horizon = std::min(contact + kAfterContact, marks.end);
        if (marks.horizons.empty() || horizon > marks.horizons.back() + kHardlyLater)
            marks.horizons.push_back(horizon);
    }
    if (marks.horizons.empty() || marks.horizons.back() < marks.end)
        marks.horizons.push_back(marks.end);
    return marks;
}

}  // namespace poolhall::lab
