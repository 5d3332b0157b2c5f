// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/environment_maps.h"

#include <algorithm>

#include "engines/raster/full_types.h"
#include "image/decode.h"
#include "math/functions.h"

namespace rakelight::raster {
namespace {

/// All levels with their borders, which go on across the map's edges as the sphere does.
void pack_mirrored(const std::vector<OctahedralMap>& maps, EnvironmentMaps& to) {
    TextureView& view = to.mirrored_view;
    view = {};
    view.levels = int(maps.size());
    view.wrap_u = view.wrap_v = int(Wrap::clamp_to_edge);
    view.magnify_linear = view.minify_linear = 1;
    view.mip = int(MipFilter::linear);
    for (std::size_t l = 0; l < maps.size(); ++l) {
        const int size = maps[l].size;
        view.width[l] = view.height[l] = size;
        view.stride[l] = size + 2;
        view.fixed_width[l] = view.fixed_height[l] = float(size) * 32768.0f;
        view.origin[l] = std::int32_t(to.mirrored.size() / 4) + size + 3;
        for (int y = -1; y <= size; ++y)
            for (int x = -1; x <= size; ++x) {
                const vec3 c = bordered_texel(maps[l], x, y);
                to.mirrored.insert(to.mirrored.end(), {c.x, c.y, c.z, 1.0f});
            }
    }
    view.rgba32f = to.mirrored.data();
}

std::shared_ptr<const EnvironmentMaps> make_maps(const ImageHandle& image, Context& context) {
    const MipChain chain =
        make_mip_chain(image ? decode(*image, context) : studio_panorama(), ColorSpace::srgb, context);
    auto out = std::make_shared<EnvironmentMaps>();
    out->image = image;
    out->sky = pack_texture(chain, {image, ColorSpace::srgb, Wrap::repeat, Wrap::clamp_to_edge},
                            MemoryCharge(context.memory()));
    out->sky_view = with_filters(*out->sky, {.wrap_v = Wrap::clamp_to_edge});
    const EnvironmentLight light = make_environment_light(chain, context);
    out->irradiance = light.irradiance;
    pack_mirrored(light.mirrored, *out);
    return out;
}

EnvironmentView view_of(const EnvironmentMaps& maps, const Environment& environment) {
    EnvironmentView view{};
    view.specular = &maps.mirrored_view;
    view.sky = &maps.sky_view;
    for (std::size_t i = 0; i < 9; ++i)
        for (std::size_t c = 0; c < 3; ++c) view.irradiance[i][c] = maps.irradiance[i][c];
    view.turn[0] = float(math::cos(environment.rotation_rad));
    view.turn[1] = float(math::sin(environment.rotation_rad));
    view.intensity = environment.intensity;
    return view;
}

void set_rays(const View& view, int tile_x, int tile_y, SkyJob& out) {
    if (view.orthographic) {
        const dvec3 forward = -view.camera_to_world[2].xyz();
        for (std::size_t c = 0; c < 3; ++c) out.ray[c][0] = out.ray[c][1] = 0, out.ray[c][2] = float(forward[c]);
        out.pixel_size = 0;
        return;
    }
    set_ray(view, tile_x, tile_y, out.ray);
    out.pixel_size = float(2.0 / (view.height * view.scale_y));
}

}  // namespace

void EnvironmentCache::update(DrawList& list, Context& context) {
    list.environment = nullptr;
    const std::optional<Environment>& wanted = list.scene.environment;
    if (!wanted || !(wanted->is_light || wanted->is_background)) return maps_.reset();
    if (!maps_ || maps_->image != wanted->image) {
        maps_.reset();
        try {
            maps_ = make_maps(wanted->image, context);
        } catch (const Error& error) {
            context.throw_if_cancelled();
            const bool is_built_in = !wanted->image;
            context.report().add(Remark::warning, is_built_in ? list.scene.source : wanted->image->file,
                                 is_built_in ? "the built-in studio" : wanted->image->name,
                                 "environment left out: " + error.reason());
        }
    }
    if (!maps_) return;
    list.environment = maps_;
    list.environment_view = view_of(*maps_, *wanted);
}

bool has_sky(const DrawList& list) { return list.environment && list.scene.environment->is_background; }

void fill_sky(const TileJob& job, std::size_t tile, std::vector<vec4>& color, TileScratch& s) {
    SkyJob sky{};
    sky.environment = &job.front.list.environment_view;
    set_rays(job.front.view, job.grid.origin_x(tile), job.grid.origin_y(tile), sky);
    sky.count = tile_pixels;
    for (std::size_t i = 0; i < s.pixel.size(); ++i)
        s.pixel[i] = std::int32_t(std::min(i, std::size_t(tile_pixels - 1)));
    sky.pixel = s.pixel.data();
    sky.red = s.red.data(), sky.green = s.green.data(), sky.blue = s.blue.data();
    job.kernels.sky(&sky);
    for (std::size_t i = 0; i < tile_pixels; ++i) color[i] = {s.red[i], s.green[i], s.blue[i], 1.0f};
}

}  // namespace rakelight::raster
