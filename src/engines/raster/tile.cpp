// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/tile.h"

#include <algorithm>
#include <cstring>

#include "engines/raster/material_jobs.h"
#include "image/srgb_encoder.h"
#include "image/tone.h"

namespace rakelight::raster {

DisplayPixels display_pixels(const TileScratch& s) {
    return {s.display.first, std::int64_t(s.display.stride), SrgbEncoder::instance().table()};
}

std::uint32_t display_value(vec4 color) {
    std::uint8_t code[4];
    to_srgb8({&color, 1}, 4, code);
    std::uint32_t packed;
    std::memcpy(&packed, code, sizeof packed);
    return packed;
}

void encode_tile(TileScratch& s) {
    for (std::size_t y = 0; y < tile_size; ++y)
        to_srgb8(std::span(s.color).subspan(y * tile_size, tile_size), 4,
                 {reinterpret_cast<std::uint8_t*>(s.display.first + y * s.display.stride), 4 * tile_size});
}

void set_ray(const PictureCamera& view, int tile_x, int tile_y, float (&ray)[3][3]) {
    const shading::PixelRays rays = shading::pixel_rays(view, tile_x, tile_y);
    for (std::size_t c = 0; c < 3; ++c) {
        ray[c][0] = float(rays.along_x[c]);
        ray[c][1] = float(rays.along_y[c]);
        ray[c][2] = float(rays.first[c]);
    }
}

void find_runs(const TileJob& job, std::size_t tile, std::vector<DrawRun>& runs) {
    runs.clear();
    const std::uint32_t first = job.binned.offsets[tile];
    for (std::uint32_t r = job.binned.run_offsets[tile]; r < job.binned.run_offsets[tile + 1]; ++r) {
        const TileRun& run = job.binned.runs[r];
        runs.push_back({std::int32_t(run.first - first), std::int32_t(run.first - first + run.count), run.draw});
    }
}

bool has_blended(const TileJob& job, const std::vector<DrawRun>& runs) {
    return job.has_blended && std::any_of(runs.begin(), runs.end(),
                                          [&](const DrawRun& r) { return job.front.list.view(r.draw).blend != 0; });
}

ShadeJob make_job(const TileJob& job, std::uint32_t draw, int tile_x, int tile_y, std::size_t count, TileScratch& s) {
    ShadeJob out = draw_job(job.front, job.lights, draw);
    set_ray(job.front.view, tile_x, tile_y, out.ray);
    out.count = std::int32_t(count);
    for (std::size_t i = 0; i < batch_padding; ++i) {  // dead lanes repeat the last pixel
        s.pixel[count + i] = s.pixel[count - 1];
        s.batch_triangle[count + i] = s.batch_triangle[count - 1];
    }
    out.pixel = s.pixel.data();
    out.triangle = s.batch_triangle.data();
    out.triangles = s.triangles.data();
    if (is_lit_at_corners(job.front, draw)) out.lit = s.lit.data();
    if (wants_corner_frames(job.front, draw)) out.frames = s.frames.data();
    out.red = s.red.data();
    out.green = s.green.data();
    out.blue = s.blue.data();
    out.alpha = s.alpha.data();
    return out;
}

}  // namespace rakelight::raster
