#include "client/desktop/render/canvas.hpp"

namespace poolhall::client {
namespace {

bool draws_in_software(SDL_Renderer* renderer) {
    SDL_RendererInfo info;
    return SDL_GetRendererInfo(renderer, &info) == 0 && (info.flags & SDL_RENDERER_SOFTWARE) != 0;
}

}  // namespace

Canvas::Canvas(SDL_Renderer* renderer)
    : renderer_(renderer), software_(draws_in_software(renderer)) {}

void Canvas::begin(SDL_Color background) {
    mesh_.clear();
    int width = 0;
    int height = 0;
    if (SDL_GetRendererOutputSize(renderer_, &width, &height) != 0) width = height = 0;
    if (software_ && (width != width_ || height != height_)) {
        layer_.reset();
        rasterizer_.resize(width, height);
    }
    width_ = width;
    height_ = height;
    SDL_RenderSetViewport(renderer_, nullptr);
    SDL_SetRenderDrawBlendMode(renderer_, SDL_BLENDMODE_NONE);
    SDL_SetRenderDrawColor(renderer_, background.r, background.g, background.b, 255);
    SDL_RenderClear(renderer_);
}

void Canvas::reset() {
    layer_.reset();
}

void Canvas::copy(SDL_Texture* texture, const SDL_FRect& target) {
    flush();
    // Set at each draw: under OpenGL the blend mode of one draw leaks into the next.
    SDL_SetTextureBlendMode(texture, SDL_BLENDMODE_BLEND);
    SDL_RenderCopyF(renderer_, texture, nullptr, &target);
}

void Canvas::copy_opaque(SDL_Texture* texture, const SDL_FRect& target) {
    flush();
    SDL_SetTextureBlendMode(texture, SDL_BLENDMODE_NONE);
    SDL_RenderCopyF(renderer_, texture, nullptr, &target);
}

void Canvas::veil(SDL_Color colour) {
    flush();
    SDL_SetRenderDrawBlendMode(renderer_, SDL_BLENDMODE_BLEND);
    SDL_SetRenderDrawColor(renderer_, colour.r, colour.g, colour.b, colour.a);
    SDL_RenderFillRect(renderer_, nullptr);
}

TexturePtr Canvas::texture_of(const Image& image) {
    TexturePtr texture(SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_ARGB8888,
                                         SDL_TEXTUREACCESS_STATIC, image.width, image.height));
    if (!texture ||
        SDL_UpdateTexture(texture.get(), nullptr, image.pixels.data(), image.pitch()) != 0)
        return nullptr;
    return texture;
}

void Canvas::flush() {
    if (mesh_.empty()) return;
    if (software_) {
        flush_in_software();
    } else {
        SDL_SetRenderDrawBlendMode(renderer_, SDL_BLENDMODE_BLEND);
        SDL_RenderGeometry(renderer_, nullptr, mesh_.vertices.data(),
                           static_cast<int>(mesh_.vertices.size()), mesh_.indices.data(),
                           static_cast<int>(mesh_.indices.size()));
    }
    mesh_.clear();
}

void Canvas::flush_in_software() {
    if (!layer_) layer_ = texture_of(rasterizer_.layer());
    if (!layer_) return;
    rasterizer_.draw(mesh_);
    SDL_SetTextureBlendMode(layer_.get(), SDL_BLENDMODE_BLEND);
    for (const SDL_Rect& band : rasterizer_.dirty_bands()) {
        const Image& layer = rasterizer_.layer();
        SDL_UpdateTexture(layer_.get(), &band, layer.row(band.y) + band.x, layer.pitch());
        SDL_RenderCopy(renderer_, layer_.get(), &band, &band);
    }
    rasterizer_.clear();
}

}  // namespace poolhall::client
