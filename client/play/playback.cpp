#include "client/play/playback.hpp"

#include <algorithm>
#include <utility>

namespace poolhall::client {
namespace {

constexpr double kTick = Playback::kStep;
constexpr double kLeastDelay = 2 * kTick;
constexpr double kMostDelay = 10 * kTick;
/// How fast a delay that proved too long shrinks, s a second.
constexpr double kDelayDecay = 0.005;
/// Rate at which an excess of unplayed time is worked off, 1/s. A tick too much plays 5 % faster,
/// which nobody sees.
constexpr double kCatchUpGain = 1.5;
/// Steps add up 1/30 s, ticks are multiples of it: what differs by less is the same moment, s.
constexpr double kRounding = 1e-9;
constexpr double kSlowest = 0.85;
constexpr double kFastest = 8;
/// Shots that may wait while step mode holds the time; the oldest are given up beyond it.
constexpr std::size_t kMaxShots = 16;

}  // namespace

void Playback::begin(Shot shot) {
    if (shots_.size() == kMaxShots) end_shot();
    shots_.push_back(std::move(shot));
    if (shots_.size() == 1) show_first();
}

Shot* Playback::newest() {
    return shots_.empty() ? nullptr : &shots_.back();
}

void Playback::clear() {
    shots_.clear();
    passed_.clear();
}

void Playback::advance(double dt) {
    if (shots_.empty()) return;
    const ShotTimeline& timeline = shots_.front().timeline;
    if (!started_ && !timeline.complete() && unplayed() < delay_) return;
    const double target = time_ + dt * rate(dt);
    const bool starves = target > timeline.known_until() && !timeline.complete();
    if (starves && !starved_) delay_ += kTick / 2;
    starved_ = starves;
    move_to(std::min(target, timeline.known_until()));
}

bool Playback::step(int count) {
    if (shots_.empty()) return false;
    const ShotTimeline& timeline = shots_.front().timeline;
    const double target = time_ + count * kStep;
    if (count < 0) {
        if (time_ <= timeline.begin()) return false;
        seek(target < timeline.begin() + kRounding ? timeline.begin() : target);
        return true;
    }
    if (target > timeline.known_until() + kRounding && !timeline.complete()) return false;
    move_to(target > timeline.known_until() - kRounding ? timeline.known_until() : target);
    return true;
}

void Playback::seek(double t) {
    if (shots_.empty()) return;
    const ShotTimeline& timeline = shots_.front().timeline;
    show(std::clamp(t, timeline.begin(), timeline.known_until()));
}

std::optional<Ruling> Shot::ruling_at(double t) const {
    return ruling && t >= ruling->decided_at ? ruling : std::nullopt;
}

std::optional<Ruling> Playback::ruling() const {
    return shots_.empty() ? std::nullopt : shots_.front().ruling_at(time_);
}

std::vector<Playback::Passed> Playback::take_passed() {
    return std::exchange(passed_, {});
}

void Playback::show(double t) {
    started_ = true;
    time_ = t;
    const ShotTimeline& timeline = shots_.front().timeline;
    const auto events = timeline.events();
    const std::size_t until = timeline.events_until(t);
    while (next_event_ < until)
        passed_.emplace_back(events[next_event_++]);
    while (next_event_ > until)
        passed_.emplace_back(TakenBack{events[--next_event_]});
}

void Playback::move_to(double t) {
    show(t);
    const ShotTimeline& timeline = shots_.front().timeline;
    if (timeline.complete() && t >= timeline.known_until()) end_shot();
}

void Playback::end_shot() {
    passed_.emplace_back(ShotFinished{std::move(shots_.front())});
    shots_.pop_front();
    if (!shots_.empty()) show_first();
}

void Playback::show_first() {
    time_ = shots_.front().timeline.begin();
    next_event_ = 0;
    started_ = false;
    passed_.emplace_back(ShotBegan{});
}

double Playback::unplayed() const {
    double total = -time_ + shots_.front().timeline.known_until();
    for (std::size_t i = 1; i < shots_.size(); ++i) {
        total += shots_[i].timeline.known_until() - shots_[i].timeline.begin();
    }
    return total;
}

double Playback::rate(double dt) {
    if (pacing_ == Pacing::kSteady) return 1;
    delay_ = std::clamp(delay_ - kDelayDecay * dt, kLeastDelay, kMostDelay);
    const double excess = unplayed() - delay_;
    // The last stretch of a shot is played out as it was: nothing more will come to wait for.
    const double slowest = shots_.back().timeline.complete() ? 1 : kSlowest;
    return std::clamp(1 + kCatchUpGain * excess, slowest, kFastest);
}

}  // namespace poolhall::client
