// poolhall-view-gallery FOLDER: saves a picture of each kind of view, for people to look at.

#include "tests/client/desktop_view/picture.hpp"
#include "tests/client/desktop_view/sample_views.hpp"

#include <SDL2/SDL_image.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

namespace {

using poolhall::client::Picture;
namespace samples = poolhall::client::samples;

double milliseconds(Picture& picture, const samples::NamedView& view) {
    const auto start = std::chrono::steady_clock::now();
    picture.draw(view);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

bool save(const samples::NamedView& view, const std::filesystem::path& folder) {
    Picture picture(view.size);
    const double first = milliseconds(picture, view);
    constexpr int kAgain = 20;
    double again = 0;
    for (int i = 0; i < kAgain; ++i)
        again += milliseconds(picture, view) / kAgain;
    const std::string path = (folder / (view.name + ".png")).string();
    if (IMG_SavePNG(picture.surface(), path.c_str()) != 0) {
        std::fprintf(stderr, "%s: %s\n", path.c_str(), IMG_GetError());
        return false;
    }
    std::printf("%-40s %4d x %4d   first %6.1f ms, then %5.2f ms\n", path.c_str(), view.size.x,
                view.size.y, first, again);
    return true;
}

bool save_all(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    for (const samples::NamedView& view : samples::all()) {
        if (!save(view, folder)) return false;
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: poolhall-view-gallery FOLDER\n", stderr);
        return 2;
    }
    try {
        return save_all(argv[1]) ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "poolhall-view-gallery: %s\n", error.what());
        return 1;
    }
}
