#include "client/lab/recorded/ball_courses.hpp"

namespace poolhall::lab {

namespace {

/// The ball reaches `t` with velocity v.
void finish(BallCourses::Stretch& stretch, double t, Vec2 v) {
    if (t > stretch.t) stretch.a = (1 / (t - stretch.t)) * (v - stretch.v);
}

}  // namespace

void BallCourses::set(const Scene& scene, const ShotTrace& trace) {
    courses_.resize(scene.balls.size());
    for (std::size_t i = 0; i < courses_.size(); ++i) {
        courses_[i].clear();
        courses_[i].push_back({0, xy(scene.balls[i].state.r), xy(scene.balls[i].state.v), {}});
    }
    for (const ShotEvent& event : trace.events) {
        for (std::size_t i = 0; i < event.ball_count; ++i) {
            auto& course = courses_[event.balls[i].value];
            finish(course.back(), event.t, xy(event.before[i].v));
            course.push_back({event.t, xy(event.after[i].r), xy(event.after[i].v), {}});
        }
    }
    end_ = trace.duration;
    for (std::size_t i = 0; i < courses_.size(); ++i)
        finish(courses_[i].back(), end_, xy(trace.balls[i].state.v));
}

}  // namespace poolhall::lab
