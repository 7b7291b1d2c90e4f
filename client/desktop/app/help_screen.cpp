#include "client/desktop/app/help_screen.hpp"

#include "client/desktop/view/panels.hpp"

namespace poolhall::client {

Answer HelpScreen::handle(const ScreenEvent& event) {
    switch (event.sdl.type) {
        case SDL_KEYDOWN:
            if (event.key != SDLK_F1 && event.key != SDLK_SPACE) return Answer::kPassed;
            return event.sdl.key.repeat != 0 ? Answer::kTaken : Answer::kClose;
        case SDL_MOUSEBUTTONDOWN:
            return event.sdl.button.button == SDL_BUTTON_LEFT ? Answer::kClose : Answer::kTaken;
        case SDL_MOUSEMOTION:
            return Answer::kTaken;
        default:
            return Answer::kPassed;
    }
}

void HelpScreen::draw(const Frame& frame) {
    draw_help(frame.surface.canvas, frame.surface.text);
}

}  // namespace poolhall::client
