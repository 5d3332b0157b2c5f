// SPDX-License-Identifier: Apache-2.0
#include <rakelight/tools/thumbnail.h>

#include <algorithm>
#include <map>

#include "io/reduced_image.h"
#include "render/render_changed.h"

namespace rakelight {
namespace {

constexpr int least_texture_side = 512;  ///< [px] of palettes, which have a color every few texels
constexpr int texels_per_pixel = 4;      ///< a part of a texture may fill the picture

/// Textures that share a picture still do.
Scene with_reduced_textures(Scene scene, int most_side) {
    std::map<ImageHandle, ImageHandle> reduced;
    for (Texture& texture : scene.textures) {
        ImageHandle& image = reduced[texture.image];
        if (!image) image = io::reduced_image(texture.image, most_side);
        texture.image = image;
    }
    return scene;
}

}  // namespace

std::vector<std::byte> thumbnail(const PictureRequest& request, Context& context) {
    const int side = std::max(request.settings.width, request.settings.height);
    const int most_side = std::max(least_texture_side, texels_per_pixel * side);
    std::vector<std::byte> file;
    render_changed(
        request, [&](Scene scene) { return with_reduced_textures(std::move(scene), most_side); }, file, context);
    return file;
}

}  // namespace rakelight
