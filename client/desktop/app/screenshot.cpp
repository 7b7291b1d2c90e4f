#include "client/desktop/app/screenshot.hpp"

#include "client/files/output_file.hpp"

#include <SDL2/SDL_image.h>

#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <ostream>

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

/// Writes to a stream, which must live as long.
SDL_RWops* into(std::ostream& stream) {
    SDL_RWops* const writer = SDL_AllocRW();
    if (writer == nullptr) return nullptr;
    writer->hidden.unknown.data1 = &stream;
    writer->size = [](SDL_RWops*) { return Sint64{-1}; };
    writer->seek = [](SDL_RWops*, Sint64, int) { return Sint64{-1}; };
    writer->read = [](SDL_RWops*, void*, std::size_t, std::size_t) { return std::size_t{0}; };
    writer->write = [](SDL_RWops* self, const void* bytes, std::size_t size, std::size_t count) {
        auto& out = *static_cast<std::ostream*>(self->hidden.unknown.data1);
        out.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size * count));
        return out ? count : std::size_t{0};
    };
    writer->close = [](SDL_RWops* self) {
        SDL_FreeRW(self);
        return 0;
    };
    return writer;
}

}  // namespace

Result<std::filesystem::path, ScreenshotError> save_screenshot(
    SDL_Renderer& renderer, const std::filesystem::path& folder) {
    std::error_code unmade;  // a folder that is not there cannot be written to either
    std::filesystem::create_directories(folder, unmade);
    const auto path = free_name(folder);
    if (!path) return ScreenshotError{"No screenshot: " + folder.string() + " is full of them"};
    const Surface surface = read_pixels(renderer);
    // Whoever waits for the file finds it whole.
    files::OutputFile file(*path);
    if (!file.fault()) {
        if (!surface || IMG_SavePNG_RW(surface.get(), into(file.stream()), 1) != 0)
            return ScreenshotError{"No screenshot: " + std::string(SDL_GetError())};
        file.finish();
    }
    if (file.fault()) return ScreenshotError{"No screenshot: " + *file.fault()};
    return *path;
}

}  // namespace poolhall::client
