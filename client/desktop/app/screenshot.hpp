#pragma once

#include "shared/result.hpp"

#include <SDL2/SDL.h>

#include <filesystem>
#include <string>

namespace poolhall::client {

struct ScreenshotError {
    std::string reason;  ///< one line
};

/// Saves what the renderer has drawn and not yet presented as poolhall-001.png, or the next number
/// that is free in `folder`, which is made if need be. Gives the file's path, or why there is none.
[[nodiscard]] Result<std::filesystem::path, ScreenshotError> save_screenshot(
    SDL_Renderer& renderer, const std::filesystem::path& folder);

}  // namespace poolhall::client
