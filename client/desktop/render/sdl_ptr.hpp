#pragma once

#include <SDL2/SDL.h>

#include <memory>

namespace poolhall::client {

struct FreeTexture {
    void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
};

using TexturePtr = std::unique_ptr<SDL_Texture, FreeTexture>;

struct FreeSurface {
    void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
};

using SurfacePtr = std::unique_ptr<SDL_Surface, FreeSurface>;

}  // namespace poolhall::client
