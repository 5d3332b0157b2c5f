// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/shadows/shadow_texels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>

#include "base/format_text.h"
#include "engines/raster/multisample.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t longest_name = 60;

/// [m] the width of a texel at a place, or 0 where the map does not show it.
double texel_width(const ShadowView& map, dvec3 p) {
    const auto row = [&](int i) {
        const float(&r)[4] = map.to_light[i];
        return double(r[0]) * p.x + double(r[1]) * p.y + double(r[2]) * p.z + double(r[3]);
    };
    const dvec3 at = {row(0), row(1), row(2)};
    if (map.is_orthographic) return 1 / double(map.texels);
    if (map.faces == 6) return std::max({std::fabs(at.x), std::fabs(at.y), std::fabs(at.z)}) / double(map.texels);
    const double half = 0.5 * map.size / double(map.texels) * at.z;
    return at.z > 0 && std::max(std::fabs(at.x), std::fabs(at.y)) < half ? at.z / double(map.texels) : 0;
}

std::string name_of(const Light& light, std::size_t number) {
    if (light.name.empty()) return "light " + std::to_string(number);
    return "light '" + light.name.substr(0, longest_name) + "'";
}

/// "0.14", "12": two digits of what is below 10, all of the others.
std::string rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, value < 9.95 ? "%.2g" : "%.0f", value);
    return text;
}

}  // namespace

ShadowTexels::ShadowTexels(const TileGrid& grid)
    : step_(std::max((grid.count() + most_tiles - 1) / most_tiles, std::size_t(1))) {
    while (std::gcd(step_, std::size_t(grid.columns)) > 1) ++step_;  // else it keeps to some columns
    places_.resize((grid.count() + step_ - 1) / step_ * a_side * a_side);
}

void ShadowTexels::take(const TileJob& job, std::size_t tile, const TileScratch& scratch) {
    if (tile % step_ != 0) return;
    const bool is_sampled = job.front.settings.samples > 1;
    const float* const depth = is_sampled ? scratch.samples->depth.data() : scratch.depth.data();
    const std::int32_t* const visible = is_sampled ? scratch.samples->visible.data() : scratch.visible.data();
    const PictureCamera& view = job.front.view;
    const Window area = job.grid.pixels(tile);
    const int left = job.grid.origin_x(tile), top = job.grid.origin_y(tile);
    const dvec3 eye = view.camera_to_world[3].xyz();
    Place* to = &places_[tile / step_ * a_side * a_side];
    for (int k = 0; k < a_side * a_side; ++k, ++to) {
        const int x = area.x + (2 * (k % a_side) + 1) * area.width / (2 * a_side),
                  y = area.y + (2 * (k / a_side) + 1) * area.height / (2 * a_side);
        const auto i = std::size_t((y - top) * tile_size + x - left);
        if (visible[i] < 0) continue;
        const double distance = view.distance_of(double(depth[i]));
        if (!std::isfinite(distance)) continue;
        to->from_eye = view.place(x + 0.5, y + 0.5, double(depth[i])) - eye;
        to->pixel_width = 2 * (view.orthographic ? 1 : distance) / (view.scale_y * view.height);
    }
}

ShadowTexels::Width ShadowTexels::width_of(const ShadowView& map, double inverse_range) const {
    std::vector<Width> widths;
    for (const Place& place : places_) {
        if (!(place.pixel_width > 0)) continue;
        const double width = texel_width(map, place.from_eye);
        if (!(width > 0) || width * double(map.texels) * inverse_range >= 1) continue;
        widths.push_back({width / place.pixel_width, width});
    }
    if (widths.empty()) return {};
    const auto quarter = widths.begin() + std::ptrdiff_t(widths.size() / 4);
    std::nth_element(widths.begin(), quarter, widths.end(),
                     [](const Width& a, const Width& b) { return a.pixels > b.pixels; });
    return *quarter;
}

void ShadowTexels::remark(const Scene& scene, std::span<const lighting::LightParameters> lights, const ShadowView* maps,
                          Context& context) const {
    Width widest;
    std::size_t light = 0, others = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (maps == nullptr || lights[i].shadow < 0) continue;
        const ShadowView& map = maps[lights[i].shadow];
        const Width width = width_of(map, map.is_orthographic ? 0 : double(lights[i].inverse_range));
        others += width.pixels >= wide;
        if (width.pixels > widest.pixels) widest = width, light = i;
    }
    if (!(widest.pixels > 0)) return;
    const bool is_wide = widest.pixels >= wide;
    std::string text = name_of(scene.lights[light], light) + ": a texel of its shadow map covers " +
                       rounded(widest.meters) + " m (about " + rounded(widest.pixels) + " pixels)";
    if (is_wide) text += "; raise 'shadow-size'";
    if (others > 1) text += format_text("; so with {} more", others - 1);
    context.report().add(is_wide ? Remark::warning : Remark::note, scene.source, {}, text, {"shadow-size"});
}

}  // namespace rakelight::raster
