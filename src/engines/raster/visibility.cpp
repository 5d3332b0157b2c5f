// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "engines/raster/coverage.h"
#include "engines/raster/tile.h"

namespace rakelight::raster {
namespace {

/// A masked triangle: the pixels that would be visible ask the texture first.
void cover_masked(const TileJob& job, const ScreenTriangle& s, std::int32_t position, const Window& area, int ox, int oy,
                  TileScratch& scratch) {
    std::size_t count = 0;
    cover(s, area, ox, oy, [&](int x, int y, float depth) {
        if (!(depth > scratch.depth[std::size_t(y * tile_size + x)])) return;
        scratch.x[count] = x;
        scratch.y[count] = y;
        scratch.triangle[count] = 0;
        scratch.batch_depth[count++] = depth;
    });
    if (count == 0) return;
    scratch.triangles.resize(1);
    make_shade_triangle(job.front, s, ox, oy, scratch.triangles[0]);
    const std::uint32_t material = job.front.list.draws[s.draw].material;
    const ShadeJob batch = make_job(job, material, count, scratch);
    job.kernels.alpha(&batch);
    const float cutoff = batch.material->alpha_cutoff;
    for (std::size_t i = 0; i < count; ++i) {
        if (!(scratch.alpha[i] >= cutoff)) continue;
        const auto p = std::size_t(scratch.y[i] * tile_size + scratch.x[i]);
        scratch.depth[p] = scratch.batch_depth[i];
        scratch.visible[p] = position;
    }
}

}  // namespace

void find_visible(const TileJob& job, std::size_t tile, TileScratch& scratch) {
    std::fill(scratch.depth.begin(), scratch.depth.end(), -1.0f);  // farther than any key: those are 0 or more
    std::fill(scratch.visible.begin(), scratch.visible.end(), -1);
    const Window area = job.grid.pixels(tile);
    const int ox = job.grid.origin_x(tile), oy = job.grid.origin_y(tile);
    const std::uint32_t first = job.binned.offsets[tile], end = job.binned.offsets[tile + 1];
    for (std::uint32_t i = first; i < end; ++i) {
        const ScreenTriangle& s = job.binned.at(job.binned.items[i]);
        const MaterialView& material = job.front.list.materials[job.front.list.draws[s.draw].material].view;
        const auto position = std::int32_t(i - first);
        if (material.blend) continue;
        if (material.alpha_cutoff >= 0) {
            cover_masked(job, s, position, area, ox, oy, scratch);
            continue;
        }
        cover(s, area, ox, oy, [&](int x, int y, float depth) {
            const auto p = std::size_t(y * tile_size + x);
            if (!(depth > scratch.depth[p])) return;  // the first of equals stays
            scratch.depth[p] = depth;
            scratch.visible[p] = position;
        });
    }
}

}  // namespace rakelight::raster
