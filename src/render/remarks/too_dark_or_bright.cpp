// SPDX-License-Identifier: Apache-2.0
#include "render/remarks/too_dark_or_bright.h"

#include <algorithm>
#include <cmath>

#include "base/format_text.h"
#include "render/output/picture_files.h"
#include "render/remarks/why_black.h"

namespace rakelight {
namespace {

constexpr double most_white = 2.0 / 3;  ///< of what the model covers; above that a remark is due
constexpr double least_black = 0.9;  ///< the same of multisampled pictures, whose edges are mixed with the background

/// Pixels of the background that are as `code` in red, green and blue.
std::uint64_t background_pixels(const PictureRequest& request, const RenderStats& stats, std::uint8_t code) {
    if (!is_code(request.settings.background.xyz(), code)) return 0;  // which no curve changes
    const Window window = whole_window(request.settings);
    return std::uint64_t(window.width) * std::uint64_t(window.height) - stats.pixels_covered;
}

/// Something was blended over the picture. Such pixels are counted as black or white, but not as covered. One sample
/// a pixel is shaded once where it is opaque, so that more are blended; of more samples that cannot be told.
bool is_blended(const Scene& scene, const RenderStats& stats) {
    return stats.pixels_shaded > stats.pixels_covered && has_blended(scene);
}

}  // namespace

void ExtremePixels::add(std::uint64_t black, std::uint64_t white) {
    if (black > 0) black_.fetch_add(black, std::memory_order_relaxed);
    if (white > 0) white_.fetch_add(white, std::memory_order_relaxed);
}

void ExtremePixels::add(std::span<const std::uint32_t> srgb8) {
    constexpr std::size_t block = 16;  // a fixed count, so that the compiler makes vectors of it
    constexpr std::uint32_t rgb = 0xFFFFFF;
    std::uint32_t black = 0, white = 0;
    std::size_t i = 0;
    for (; i + block <= srgb8.size(); i += block)
        for (std::size_t k = 0; k < block; ++k) {
            black += std::uint32_t((srgb8[i + k] & rgb) == 0);
            white += std::uint32_t((srgb8[i + k] & rgb) == rgb);
        }
    for (; i < srgb8.size(); ++i) {
        black += std::uint32_t((srgb8[i] & rgb) == 0);
        white += std::uint32_t((srgb8[i] & rgb) == rgb);
    }
    add(black, white);
}

void ExtremePixels::add_row(const std::byte* row, std::size_t count, int channels) {
    std::uint64_t black = 0, white = 0;
    for (std::size_t i = 0; i < count; ++i, row += channels) {
        black += std::uint64_t((row[0] | row[1] | row[2]) == std::byte{0});
        white += std::uint64_t((row[0] & row[1] & row[2]) == std::byte{255});
    }
    add(black, white);
}

void remark_extremes(const Scene& scene, const PictureRequest& request, const PictureResult& result, Report& report) {
    const RenderStats& stats = result.stats;
    const bool has_sky = scene.environment && scene.environment->is_background;
    if (stats.pixels_covered == 0 || stats.pixels_marked > 0 || has_sky || is_blended(scene, stats)) return;
    const auto share = [&](std::uint64_t all, std::uint8_t code) {
        return (double(all) - double(background_pixels(request, stats, code))) / double(stats.pixels_covered);
    };
    if (share(result.black_pixels, 0) >= (request.settings.samples > 1 ? least_black : 1.0))
        report.add(Remark::warning, request.input, "", "all of the model is black: " + why_black(scene, request),
                   {"light-cutoff", "light-intensity", "exposure"});
    const double white = share(result.white_pixels, 255);
    if (white <= most_white || is_unlit(scene, request)) return;
    const bool is_fog_white = scene.fog.kind != FogKind::none && shows_as(request, scene.fog.color, 255);
    report.add(Remark::warning, request.input, "",
               format_text("{} % of the pixels that the model covers are white, 1 or more in red, green and "
                           "blue{}'exposure', 'tone-mapping', 'light-intensity'",
                           int(std::lround(100 * std::min(white, 1.0))),
                           is_fog_white ? ", and so is the fog: see 'fog', " : ": see "),
               {"fog", "exposure", "tone-mapping", "light-intensity"});
}

}  // namespace rakelight
