// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/textures/environment_maps.h"

#include <algorithm>

#include "engines/raster/kernels/full_types.h"
#include "math/functions.h"
#include "shading/environment.h"

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

std::shared_ptr<const EnvironmentMaps> pack(const shading::EnvironmentImages& images, const ImageHandle& image,
                                            Context& context) {
    auto out = std::make_shared<EnvironmentMaps>();
    out->image = image;
    out->sky = pack_texture(images.sky, {image, ColorSpace::srgb, Wrap::repeat, Wrap::clamp_to_edge},
                            MemoryCharge(context.memory()));
    out->sky_view = with_filters(*out->sky, {.wrap_v = Wrap::clamp_to_edge});
    out->irradiance = images.light.irradiance;
    pack_mirrored(images.light.mirrored, *out);
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
    if (!shading::uses_environment(list.scene)) return maps_.reset();
    const ImageHandle& image = list.scene.environment->image;
    if (!maps_ || maps_->image != image) {
        maps_.reset();
        const auto keep = [&](const shading::EnvironmentImages& images) { maps_ = pack(images, image, context); };
        shading::load_environment(list.scene, keep, context);
    }
    if (!maps_) return;
    list.environment = maps_;
    list.environment_view = view_of(*maps_, *list.scene.environment);
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
