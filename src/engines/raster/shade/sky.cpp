// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/shade/sky.h"

#include <algorithm>

namespace rakelight::raster {
namespace {

void set_rays(const PictureCamera& view, int tile_x, int tile_y, SkyJob& out) {
    if (view.orthographic) {
        const dvec3 forward = -view.camera_to_world[2].xyz();
        for (std::size_t c = 0; c < 3; ++c) out.ray[c][0] = out.ray[c][1] = 0, out.ray[c][2] = float(forward[c]);
        out.pixel_size = 0;
        return;
    }
    set_ray(view, tile_x, tile_y, out.ray);
    out.pixel_size = float(2.0 / (view.height * view.scale_y));
}

SkyJob sky_job(const TileJob& job, std::size_t tile, TileScratch& s) {
    SkyJob sky{};
    sky.environment = &job.front.list.views.environment_view;
    set_rays(job.front.view, job.grid.origin_x(tile), job.grid.origin_y(tile), sky);
    sky.pixel = s.pixel.data();
    sky.red = s.red.data(), sky.green = s.green.data(), sky.blue = s.blue.data();
    return sky;
}

}  // namespace

bool has_sky(const DrawList& list) { return list.views.environment && list.scene.environment->is_background; }

void fill_sky(const TileJob& job, std::size_t tile, std::vector<vec4>& color, TileScratch& s) {
    SkyJob sky = sky_job(job, tile, s);
    sky.count = tile_pixels;
    for (std::size_t i = 0; i < s.pixel.size(); ++i)
        s.pixel[i] = std::int32_t(std::min(i, std::size_t(tile_pixels - 1)));
    job.kernels.sky(&sky);
    for (std::size_t i = 0; i < tile_pixels; ++i) color[i] = {s.red[i], s.green[i], s.blue[i], 1.0f};
}

void put_sky(const TileJob& job, std::size_t tile, const std::int32_t* visible, TileScratch& s) {
    SkyJob sky = sky_job(job, tile, s);
    sky.count = job.front.kernels.collect(visible, -1, 0, s.pixel.data(), s.list_position.data());
    if (sky.count == 0) return;
    std::fill_n(s.pixel.begin() + sky.count, batch_padding, s.pixel[std::size_t(sky.count - 1)]);
    sky.display = display_pixels(s);
    job.kernels.sky(&sky);
}

}  // namespace rakelight::raster
