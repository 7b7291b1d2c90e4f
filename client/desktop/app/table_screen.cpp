#include "client/desktop/app/table_screen.hpp"

#include "client/desktop/app/audible.hpp"
#include "client/desktop/net/websocket_transport.hpp"
#include "client/play/local_match.hpp"
#include "client/play/remote_match.hpp"
#include "shared/game/end_game.hpp"

namespace poolhall::client {
namespace {

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

TableScreen::TableScreen(const Options& options)
    : tokens_(default_state_folder()),
      playback_(pacing_of(options)),
      match_(make_match(options)),
      controller_(*match_, playback_) {}

std::unique_ptr<ClientMatch> TableScreen::make_match(const Options& options) {
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

Answer TableScreen::handle(const ScreenEvent& event) {
    switch (event.sdl.type) {
        case SDL_KEYDOWN:
            if (const auto action = input_.key_down(event.key, event.sdl.key.repeat != 0))
                return act(*action);
            return Answer::kPassed;
        case SDL_KEYUP:
            input_.key_up(event.key);
            return Answer::kPassed;
        case SDL_MOUSEMOTION:
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP:
            return pointed(event);
        case SDL_WINDOWEVENT:
            if (event.sdl.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
                input_.release_all();
                controller_.pointer_released();
            }
            return Answer::kPassed;
        case SDL_RENDER_TARGETS_RESET:
        case SDL_RENDER_DEVICE_RESET:
            view_.reset();
            return Answer::kPassed;
        default:
            return Answer::kPassed;
    }
}

Answer TableScreen::pointed(const ScreenEvent& event) {
    const SDL_Event& sdl = event.sdl;
    const Vec2 r = view_.to_table(event.pointer);
    if (sdl.type == SDL_MOUSEMOTION) {
        if (sdl.motion.xrel != 0 || sdl.motion.yrel != 0) controller_.pointer_moved(r);
    } else if (sdl.button.button != SDL_BUTTON_LEFT) {
        return Answer::kPassed;
    } else if (sdl.type == SDL_MOUSEBUTTONDOWN) {
        controller_.pointer_pressed(r);
    } else {
        controller_.pointer_released();
    }
    return Answer::kTaken;
}

Answer TableScreen::act(Action action) {
    switch (action) {
        case Action::kExit:
        case Action::kFrameRate:
        case Action::kScreenshot:
            return Answer::kPassed;
        case Action::kCopyCode:
            copy_code();
            return Answer::kTaken;
        case Action::kMute:
            sounds_.set_muted(!sounds_.muted());
            ++sound_changes_;
            return Answer::kTaken;
        case Action::kStepMode:
        case Action::kCollisionMode:
        case Action::kSolvers:
        case Action::kGo:
        case Action::kHotSeat:
            controller_.act(action);
            return Answer::kTaken;
    }
    return Answer::kPassed;
}

void TableScreen::copy_code() {
    const std::string code = controller_.match_view().code;
    if (code.empty()) {
        controller_.show_status("There is no join code here");
    } else if (SDL_SetClipboardText(code.c_str()) == 0) {
        controller_.show_status("Copied " + code);
    } else {
        controller_.show_status("Not copied: " + std::string(SDL_GetError()));
    }
}

void TableScreen::update(double dt, double now) {
    controller_.update(dt, now, input_.take_steering());
    play_sounds();
}

void TableScreen::play_sounds() {
    const auto heard = controller_.take_sounds();
    if (heard.empty()) return;
    const Table table = controller_.view().table;
    for (const TableSound& one : heard) {
        if (const auto sound = audible(one, table))
            sounds_.play(sound->sound, sound->strength, sound->pan);
    }
}

void TableScreen::draw(const Frame& frame) {
    ViewState state = controller_.view(frame.frames_per_second);
    state.muted = sounds_.muted();
    view_.draw(frame.surface, state, frame.now);
}

bool TableScreen::moves() const {
    return controller_.animated() || input_.steers();
}

std::uint64_t TableScreen::revision() const {
    return controller_.revision() + sound_changes_;
}

double TableScreen::due_in(double now) const {
    return match_->due_in(now);
}

std::string TableScreen::title() const {
    const MatchView match = controller_.match_view();
    return "Poolhall " + (match.link == Link::kOffline ? "practice" : match.code);
}

bool TableScreen::show_status(const std::string& line) {
    controller_.show_status(line);
    return true;
}

}  // namespace poolhall::client
