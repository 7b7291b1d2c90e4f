#include "client/desktop/app/window.hpp"

#include "client/desktop/view/layout.hpp"

namespace poolhall::client {
namespace {

[[noreturn]] void fail(const std::string& what) {
    throw WindowError(what + ": " + SDL_GetError());
}

SDL_Renderer* make_renderer(SDL_Window* window) {
    SDL_Renderer* renderer = SDL_CreateRenderer(window, -1, SDL_RENDERER_PRESENTVSYNC);
    return renderer != nullptr ? renderer : SDL_CreateRenderer(window, -1, SDL_RENDERER_SOFTWARE);
}

}  // namespace

Window::Sdl::Sdl() {
    SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "linear");
    SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
    // The software renderer is asked for where OpenGL is slow or broken: its picture should not go
    // through OpenGL then.
    SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
    if (SDL_Init(SDL_INIT_VIDEO | SDL_INIT_EVENTS) != 0) fail("no display");
}

Window::Sdl::~Sdl() {
    SDL_Quit();
}

Window::Window(const std::string& title, int width, int height) : title_(title) {
    constexpr int kAnywhere = SDL_WINDOWPOS_CENTERED;
    // Hidden at first: the renderer may make the window anew to suit itself.
    constexpr Uint32 kFlags = SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI | SDL_WINDOW_HIDDEN;
    window_.reset(SDL_CreateWindow(title.c_str(), kAnywhere, kAnywhere, width, height, kFlags));
    if (!window_) fail("no window");
    SDL_SetWindowMinimumSize(window_.get(), kMinWindowWidth, kMinWindowHeight);
    renderer_.reset(make_renderer(window_.get()));
    if (!renderer_) fail("no renderer");
    SDL_ShowWindow(window_.get());
}

SDL_FPoint Window::to_pixels(int x, int y) const {
    int width = 1;
    int height = 1;
    int pixel_width = 1;
    int pixel_height = 1;
    SDL_GetWindowSize(window_.get(), &width, &height);
    SDL_GetRendererOutputSize(renderer_.get(), &pixel_width, &pixel_height);
    const auto scaled = [](int at, int pixels, int points) {
        return static_cast<float>(at) * static_cast<float>(pixels) / static_cast<float>(points);
    };
    return {scaled(x, pixel_width, width), scaled(y, pixel_height, height)};
}

double Window::frame_time() const {
    constexpr int kUsual = 60;  // Hz
    constexpr int kLeast = 24;  // Hz; virtual displays name less, and mean nothing by it
    SDL_DisplayMode mode{};
    const int display = SDL_GetWindowDisplayIndex(window_.get());
    const bool known = display >= 0 && SDL_GetCurrentDisplayMode(display, &mode) == 0 &&
                       mode.refresh_rate >= kLeast;
    return 1.0 / (known ? mode.refresh_rate : kUsual);
}

bool Window::out_of_sight() const {
    return (SDL_GetWindowFlags(window_.get()) & (SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN)) != 0;
}

void Window::set_title(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    SDL_SetWindowTitle(window_.get(), title.c_str());
}

}  // namespace poolhall::client
