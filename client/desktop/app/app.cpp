#include "client/desktop/app/app.hpp"

#include "client/desktop/app/help_screen.hpp"
#include "client/desktop/app/screenshot.hpp"
#include "client/desktop/app/table_screen.hpp"
#include "client/desktop/net/clock.hpp"
#include "client/desktop/render/colour.hpp"
#include "client/desktop/view/table_painter.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace poolhall::client {
namespace {

constexpr double kLongestWait = 0.25;     // s between two looks at the clock when nothing happens
constexpr double kFirstFrame = 1.0 / 60;  // s that the first frame after a wait stands for
constexpr double kLongestFrame = 0.25;  // s; after a longer hiccup motion goes on from where it was
constexpr double kEarly = 0.0003;  // s that a frame may begin before its time: what waking up takes
constexpr double kHiddenFrame = 1.0 / 30;  // s
constexpr double kFrameRateMemory = 0.05;  // weight of the newest frame in the frame rate shown

/// A screen that a key lays over the others.
struct ScreenKey {
    SDL_Keycode key;
    std::unique_ptr<Screen> (*make)();
};

template <class S>
std::unique_ptr<Screen> make() {
    return std::make_unique<S>();
}

constexpr auto kScreenKeys = std::to_array<ScreenKey>({
    {SDLK_F1, make<HelpScreen>},
});

int milliseconds(double seconds) {
    return std::max(1, static_cast<int>(1000 * seconds));
}

bool on_keyboard(SDL_Keycode key) {
    return SDL_GetScancodeFromKey(key) != SDL_SCANCODE_UNKNOWN;
}

/// Keys with Alt or the system's key belong to the desktop, but not their coming up.
SDL_Keycode key_of(const SDL_Event& event) {
    if (event.type != SDL_KEYDOWN && event.type != SDL_KEYUP) return SDLK_UNKNOWN;
    const SDL_Keysym& key = event.key.keysym;
    if (event.type == SDL_KEYDOWN && (key.mod & (KMOD_ALT | KMOD_GUI)) != 0) return SDLK_UNKNOWN;
    return meant(key, on_keyboard);
}

SDL_FPoint pointer_of(const SDL_Event& event, const Window& window) {
    if (event.type == SDL_MOUSEMOTION) return window.to_pixels(event.motion.x, event.motion.y);
    if (event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP)
        return window.to_pixels(event.button.x, event.button.y);
    return {0, 0};
}

}  // namespace

App::App(const Options& options)
    : screenshots_(options.screenshots),
      window_("Poolhall", options.width, options.height),
      surface_(&window_.renderer()) {
    screens_.push(std::make_unique<TableScreen>(options));
}

void App::run() {
    time_ = clock_now();
    while (running_) {
        handle_events();
        pass_time();
        draw_if_needed();
    }
}

void App::handle_events() {
    SDL_Event event;
    const double patience = std::min(kLongestWait, screens_.due_in(clock_now()));
    if (stale()) await_next_frame();
    bool more = stale() ? SDL_PollEvent(&event) != 0
                        : SDL_WaitEventTimeout(&event, milliseconds(patience)) != 0;
    while (more) {
        handle(event);
        more = SDL_PollEvent(&event) != 0;
    }
}

void App::handle(const SDL_Event& event) {
    const ScreenEvent for_screens{event, key_of(event), pointer_of(event, window_)};
    if (screens_.handle(for_screens)) return;
    switch (event.type) {
        case SDL_QUIT:
            running_ = false;
            break;
        case SDL_WINDOWEVENT:
            handle_window(event.window);
            break;
        case SDL_RENDER_TARGETS_RESET:
        case SDL_RENDER_DEVICE_RESET:
            surface_.reset();
            redraw_ = true;
            break;
        case SDL_KEYDOWN:
            if (event.key.repeat == 0) press(for_screens.key);
            break;
        default:
            break;
    }
}

void App::handle_window(const SDL_WindowEvent& event) {
    switch (event.event) {
        case SDL_WINDOWEVENT_EXPOSED:
        case SDL_WINDOWEVENT_SIZE_CHANGED:
        case SDL_WINDOWEVENT_RESTORED:
        case SDL_WINDOWEVENT_SHOWN:
            redraw_ = true;
            break;
        default:
            break;
    }
}

void App::press(SDL_Keycode key) {
    const auto action = action_of(key);
    if (action == Action::kExit) running_ = false;
    if (action == Action::kScreenshot) screenshot_wanted_ = true;
    if (action == Action::kFrameRate) {
        shows_frame_rate_ = !shows_frame_rate_;
        redraw_ = true;
    }
    for (const ScreenKey& screen : kScreenKeys) {
        if (screen.key == key) screens_.push(screen.make());
    }
}

void App::pass_time() {
    const double now = clock_now();
    const double dt = was_moving_ ? std::min(now - time_, kLongestFrame) : kFirstFrame;
    time_ = now;
    screens_.update(dt, now);
    // That a motion has come to its end is shown too.
    if (was_moving_ && !screens_.moves() && shows_frame_rate_) redraw_ = true;
    was_moving_ = screens_.moves();
}

void App::draw_if_needed() {
    if (window_.out_of_sight()) {
        redraw_ = true;
        SDL_Delay(static_cast<Uint32>(milliseconds(kHiddenFrame)));
        return;
    }
    if (!stale() || next_frame_in() > 0) return;
    drawn_revision_ = screens_.revision();
    redraw_ = false;
    draw();
}

void App::draw() {
    note_frame(clock_now());
    window_.set_title(screens_.title());
    surface_.canvas.begin(to_colour(kRoom));
    if (surface_.canvas.width() > 0 && surface_.canvas.height() > 0)
        screens_.draw({surface_, time_, frames_per_second()});
    surface_.canvas.finish();
    if (screenshot_wanted_) take_screenshot();
    SDL_RenderPresent(&window_.renderer());
}

void App::take_screenshot() {
    screenshot_wanted_ = false;
    const auto saved = save_screenshot(window_.renderer(), screenshots_);
    screens_.show_status(saved.ok() ? "Saved " + saved->string() : saved.error().reason);
}

std::optional<double> App::frames_per_second() const {
    if (!shows_frame_rate_) return std::nullopt;
    return drew_motion_ ? 1 / frame_time_ : 0;
}

void App::note_frame(double now) {
    const bool follows = drew_motion_ && screens_.moves();
    if (follows) frame_time_ += kFrameRateMemory * (now - drawn_at_ - frame_time_);
    drew_motion_ = screens_.moves();
    drawn_at_ = now;
}

double App::next_frame_in() const {
    return drawn_at_ + window_.frame_time() - kEarly - clock_now();
}

void App::await_next_frame() {
    const double left = next_frame_in();
    if (left > 0) std::this_thread::sleep_for(std::chrono::duration<double>(left));
}

bool App::stale() const {
    return screens_.moves() || redraw_ || screenshot_wanted_ ||
           screens_.revision() != drawn_revision_;
}

}  // namespace poolhall::client
