#include "client/desktop/app/screen_stack.hpp"

#include <algorithm>

namespace poolhall::client {

void ScreenStack::push(std::unique_ptr<Screen> screen) {
    screens_.push_back(std::move(screen));
    ++changes_;
}

bool ScreenStack::handle(const ScreenEvent& event) {
    for (std::size_t i = screens_.size(); i-- > 0;) {
        const Answer answer = screens_[i]->handle(event);
        if (answer == Answer::kPassed) continue;
        if (answer == Answer::kClose) {
            changes_ += 1 + screens_[i]->revision();
            screens_.erase(screens_.begin() + static_cast<std::ptrdiff_t>(i));
        }
        return true;
    }
    return false;
}

void ScreenStack::update(double dt, double now) {
    for (const auto& screen : screens_)
        screen->update(dt, now);
}

void ScreenStack::draw(const Frame& frame) {
    for (const auto& screen : screens_)
        screen->draw(frame);
}

bool ScreenStack::moves() const {
    return std::any_of(screens_.begin(), screens_.end(),
                       [](const auto& screen) { return screen->moves(); });
}

std::uint64_t ScreenStack::revision() const {
    std::uint64_t total = changes_;
    for (const auto& screen : screens_)
        total += screen->revision();
    return total;
}

double ScreenStack::due_in(double now) const {
    double soonest = std::numeric_limits<double>::infinity();
    for (const auto& screen : screens_)
        soonest = std::min(soonest, screen->due_in(now));
    return soonest;
}

std::string ScreenStack::title() const {
    for (auto screen = screens_.rbegin(); screen != screens_.rend(); ++screen) {
        if (std::string title = (*screen)->title(); !title.empty()) return title;
    }
    return "";
}

void ScreenStack::show_status(const std::string& line) {
    for (auto screen = screens_.rbegin(); screen != screens_.rend(); ++screen) {
        if ((*screen)->show_status(line)) return;
    }
}

}  // namespace poolhall::client
