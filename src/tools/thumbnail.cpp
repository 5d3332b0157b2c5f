// SPDX-License-Identifier: Apache-2.0
#include <rakelight_internal/tools/thumbnail.h>

#include <algorithm>

#include "render/picture.h"
#include "tools/thumbnail_textures.h"

namespace rakelight {
namespace {

constexpr int least_texture_side = 512;   ///< [px] of palettes, which have a color every few texels
constexpr int texels_per_pixel = 4;       ///< a part of a texture may fill the picture
constexpr int large_texture_side = 1024;  ///< [px] longer ones take long: then 2 texels a pixel
/// A PNG file of 2048 x 2048 pixels takes 60 ms to decode (AMD EPYC with AVX-512, zlib 1.2.13): 70 million a second. Half
/// of the time is for everything else.
constexpr double pixels_per_second = 35e6;

}  // namespace

std::vector<std::byte> thumbnail(const PictureRequest& request, double cpu_seconds, Context& context) {
    if (!(cpu_seconds > 0)) throw Error(ErrorCode::usage, "the processor time must be more than 0");
    const int side = std::max(request.settings.width, request.settings.height);
    const int most_side =
        std::clamp(texels_per_pixel * side, least_texture_side, std::max(large_texture_side, 2 * side));
    const auto most_work = std::uint64_t(std::min(cpu_seconds, 1e6) * pixels_per_second);
    std::vector<std::byte> file;
    const auto change = [&](Scene scene) {
        return with_thumbnail_textures(std::move(scene), most_side, most_work, context);
    };
    render_changed(request, change, file, context);
    return file;
}

}  // namespace rakelight
