#include "client/desktop/app/screenshot.hpp"

#include <SDL2/SDL_image.h>

#include <array>
#include <cstdio>
#include <memory>
#include <optional>

namespace poolhall::client {
namespace {

constexpr int kMaxScreenshots = 9999;

struct FreeSurface {
    void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
};

using Surface = std::unique_ptr<SDL_Surface, FreeSurface>;

std::optional<std::filesystem::path> free_name(const std::filesystem::path& folder) {
    for (int number = 1; number <= kMaxScreenshots; ++number) {
        std::array<char, 32> name{};
        std::snprintf(name.data(), name.size(), "poolhall-%03d.png", number);
        std::filesystem::path path = folder / name.data();
        std::error_code unreadable;  // saving will say what is wrong with it
        if (!std::filesystem::exists(path, unreadable)) return path;
    }
    return std::nullopt;
}

Surface read_pixels(SDL_Renderer& renderer) {
    int width = 0;
    int height = 0;
    if (SDL_GetRendererOutputSize(&renderer, &width, &height) != 0) return nullptr;
    constexpr auto kFormat = SDL_PIXELFORMAT_RGB24;
    Surface surface(SDL_CreateRGBSurfaceWithFormat(0, width, height, 24, kFormat));
    if (!surface) return nullptr;
    const bool read =
        SDL_RenderReadPixels(&renderer, nullptr, kFormat, surface->pixels, surface->pitch) == 0;
    return read ? std::move(surface) : nullptr;
}

}  // namespace

Result<std::filesystem::path, ScreenshotError> save_screenshot(
    SDL_Renderer& renderer, const std::filesystem::path& folder) {
    std::error_code unmade;  // a folder that is not there cannot be written to either
    std::filesystem::create_directories(folder, unmade);
    const auto path = free_name(folder);
    if (!path) return ScreenshotError{"No screenshot: " + folder.string() + " is full of them"};
    // Written beside its place first: whoever waits for the file finds it whole.
    const std::string unfinished = path->string() + ".part";
    const Surface surface = read_pixels(renderer);
    if (!surface || IMG_SavePNG(surface.get(), unfinished.c_str()) != 0) {
        return ScreenshotError{"No screenshot: " + std::string(SDL_GetError())};
    }
    std::error_code error;
    std::filesystem::rename(unfinished, *path, error);
    if (error) return ScreenshotError{"No screenshot: " + path->string() + ": " + error.message()};
    return *path;
}

}  // namespace poolhall::client
