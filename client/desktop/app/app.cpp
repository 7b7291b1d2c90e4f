#include "client/desktop/app/app.hpp"

#include "client/desktop/app/audible.hpp"
#include "client/desktop/app/screenshot.hpp"
#include "client/desktop/net/clock.hpp"
#include "client/desktop/net/websocket_transport.hpp"
#include "client/play/local_match.hpp"
#include "client/play/remote_match.hpp"
#include "shared/game/end_game.hpp"

#include <algorithm>

namespace poolhall::client {
namespace {

constexpr double kLongestWait = 0.25;     // s between two looks at the clock when nothing happens
constexpr double kFirstFrame = 1.0 / 60;  // s that the first frame after a wait stands for
constexpr double kLongestFrame = 0.25;  // s; after a longer hiccup motion goes on from where it was
constexpr double kUnpacedFrame = 1.0 / 120;  // s of a frame when the display does not set the pace
constexpr double kShortestFrame =
    1.0 / 250;  // s of a frame when the display says that it does, and may not
constexpr double kHiddenFrame = 1.0 / 30;  // s
constexpr double kFrameRateMemory = 0.05;  // weight of the newest frame in the frame rate shown

int milliseconds(double seconds) {
    return std::max(1, static_cast<int>(1000 * seconds));
}

/// Ends the wait of the window's thread; may be called on any other.
void wake_window() {
    SDL_Event event{};
    event.type = SDL_USEREVENT;
    SDL_PushEvent(&event);
}

Pacing pacing_of(const Options& options) {
    return options.server ? Pacing::kLive : Pacing::kSteady;
}

}  // namespace

App::App(const Options& options)
    : screenshots_(options.screenshots),
      window_("Poolhall", options.width, options.height),
      view_(&window_.renderer()),
      tokens_(default_state_folder()),
      playback_(pacing_of(options)),
      match_(make_match(options)),
      controller_(*match_, playback_) {}

std::unique_ptr<ClientMatch> App::make_match(const Options& options) {
    if (!options.server) {
        return std::make_unique<LocalMatch>(practice_spec(kEndGameRules, options.settings),
                                            PerSeat<std::string>{options.name, "The house"},
                                            playback_);
    }
    transport_ =
        std::make_unique<WebSocketTransport>(*options.server, options.encoding, wake_window);
    EntryRequest wanted{to_string(*options.server), options.code, options.name, options.watch,
                        MatchSettings{.game = options.settings}};
    return std::make_unique<RemoteMatch>(std::move(wanted), *transport_, tokens_, playback_);
}

void App::run() {
    time_ = clock_now();
    while (running_) {
        handle_events();
        pass_time();
        play_sounds();
        draw_if_needed();
    }
}

void App::handle_events() {
    SDL_Event event;
    const double patience = std::min(kLongestWait, match_->due_in(clock_now()));
    bool more = stale() ? SDL_PollEvent(&event) != 0
                        : SDL_WaitEventTimeout(&event, milliseconds(patience)) != 0;
    while (more) {
        handle(event);
        more = SDL_PollEvent(&event) != 0;
    }
}

void App::handle(const SDL_Event& event) {
    view_.handle_event(event);
    switch (event.type) {
        case SDL_QUIT:
            running_ = false;
            break;
        case SDL_WINDOWEVENT:
            handle_window(event.window);
            break;
        case SDL_RENDER_TARGETS_RESET:
        case SDL_RENDER_DEVICE_RESET:
            redraw_ = true;
            break;
        case SDL_KEYDOWN:
            handle_key(event.key);
            break;
        case SDL_KEYUP:
            input_.key_up(event.key.keysym.sym);
            break;
        case SDL_MOUSEMOTION:
            if (event.motion.xrel != 0 || event.motion.yrel != 0) {
                controller_.pointer_moved(on_table(event.motion.x, event.motion.y));
            }
            break;
        case SDL_MOUSEBUTTONDOWN:
            if (event.button.button == SDL_BUTTON_LEFT) {
                controller_.pointer_pressed(on_table(event.button.x, event.button.y));
            }
            break;
        case SDL_MOUSEBUTTONUP:
            if (event.button.button == SDL_BUTTON_LEFT) controller_.pointer_released();
            break;
        default:
            break;
    }
}

void App::handle_window(const SDL_WindowEvent& event) {
    switch (event.event) {
        case SDL_WINDOWEVENT_FOCUS_LOST:
            input_.release_all();
            controller_.pointer_released();
            break;
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

void App::handle_key(const SDL_KeyboardEvent& event) {
    // Keys with Alt or the system's key belong to the desktop.
    if ((event.keysym.mod & (KMOD_ALT | KMOD_GUI)) != 0) return;
    if (const auto action = input_.key_down(event.keysym.sym, event.repeat != 0)) act(*action);
}

void App::act(Action action) {
    switch (action) {
        case Action::kExit:
            running_ = false;
            break;
        case Action::kScreenshot:
            screenshot_wanted_ = true;
            break;
        case Action::kCopyCode:
            copy_code();
            break;
        default:
            controller_.act(action);
            break;
    }
}

void App::copy_code() {
    const std::string code = controller_.view().match.code;
    if (code.empty()) {
        controller_.show_status("There is no join code here");
    } else if (SDL_SetClipboardText(code.c_str()) == 0) {
        controller_.show_status("Copied " + code);
    } else {
        controller_.show_status("Not copied: " + std::string(SDL_GetError()));
    }
}

Vec2 App::on_table(int x, int y) const {
    return view_.to_table(window_.to_pixels(x, y));
}

void App::pass_time() {
    const double now = clock_now();
    const double dt = was_busy_ ? std::min(now - time_, kLongestFrame) : kFirstFrame;
    if (was_busy_) frame_time_ += kFrameRateMemory * (dt - frame_time_);
    time_ = now;
    controller_.update(dt, now, input_.take_steering());
    was_busy_ = busy();
}

void App::play_sounds() {
    sounds_.set_muted(controller_.muted());
    const auto heard = controller_.take_sounds();
    if (heard.empty()) return;
    const Table table = controller_.view().table;
    for (const TableSound& one : heard) {
        if (const auto sound = audible(one, table))
            sounds_.play(sound->sound, sound->strength, sound->pan);
    }
}

void App::draw_if_needed() {
    if (window_.out_of_sight()) {
        redraw_ = true;
        SDL_Delay(static_cast<Uint32>(milliseconds(kHiddenFrame)));
        return;
    }
    if (!stale()) return;
    drawn_revision_ = controller_.revision();
    redraw_ = false;
    draw();
    pace();
}

void App::draw() {
    ViewState state = controller_.view();
    if (controller_.shows_frame_rate()) state.frames_per_second = 1 / frame_time_;
    window_.set_title("Poolhall " +
                      (state.match.link == Link::kOffline ? "practice" : state.match.code));
    view_.draw(state, time_);
    if (screenshot_wanted_) take_screenshot();
    SDL_RenderPresent(&window_.renderer());
}

void App::take_screenshot() {
    screenshot_wanted_ = false;
    const auto saved = save_screenshot(window_.renderer(), screenshots_);
    controller_.show_status(saved.ok() ? "Saved " + saved->string() : saved.error().reason);
}

void App::pace() {
    const double shortest = window_.paced_by_display() ? kShortestFrame : kUnpacedFrame;
    const double left = time_ + shortest - clock_now();
    if (busy() && left > 0) SDL_Delay(static_cast<Uint32>(milliseconds(left)));
}

bool App::stale() const {
    return busy() || redraw_ || screenshot_wanted_ || controller_.revision() != drawn_revision_;
}

bool App::busy() const {
    return controller_.animated() || input_.steers();
}

}  // namespace poolhall::client
