// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/inspect/inspect_shading.h"

#include "engines/raster/inspect/open_scene.h"
#include "engines/raster/multisample.h"
#include "engines/raster/shade/blend_tile.h"
#include "engines/raster/shade/shade_tile.h"
#include "math/flush_denormals.h"
#include "math/isa.h"

namespace rakelight::raster {

ShadedPicture draw_shaded(const Inspection& inspection, Shading shading, Context& context) {
    const OpenScene& of = inspection.opened();
    context.throw_if_cancelled();
    // Remarks on what the other frequencies leave out are dropped: the caller asked for this one.
    Context quiet({.threads = context.threads(), .max_memory = context.memory().limit(), .parent = &context});
    const OpenGeometry geometry(of, {}, false, quiet, shading);
    const TileJob job{.front = geometry.front,
                      .binned = geometry.binned,
                      .grid = geometry.grid,
                      .lights = of.lights(),
                      .kernels = *RL_COMMON_ISA::kernels(),
                      .has_blended = true,
                      .points = geometry.points,
                      .context = &context,
                      .occlusion = of.occlusion()};
    ShadedPicture picture{{}, geometry.front.stats};
    picture.color.resize(std::size_t(of.settings().width) * std::size_t(of.settings().height));
    std::vector<std::uint64_t> lit(geometry.grid.count(), 0);
    context.parallel_for(geometry.grid.count(), [&](std::size_t tile) {
        const FlushDenormals guard;
        if (context.cancelled()) return;
        TileScratch s;
        if (of.settings().samples > 1) {
            find_visible_samples(job, tile, s);
            shade_samples(job, tile, s);
            finish_samples(job, tile, s);
        } else {
            find_visible(job, tile, s);
            shade_opaque(job, tile, s);
            blend_transparent(job, tile, s);
        }
        lit[tile] = s.lit_pixels;
        const Window area = geometry.grid.pixels(tile);
        const int ox = geometry.grid.origin_x(tile), oy = geometry.grid.origin_y(tile);
        for (int y = area.y; y < area.y + area.height; ++y)
            for (int x = area.x; x < area.x + area.width; ++x)
                picture.color[std::size_t(y) * std::size_t(of.settings().width) + std::size_t(x)] =
                    s.color[std::size_t((y - oy) * tile_size + x - ox)];
    });
    context.throw_if_cancelled();
    for (const std::uint64_t n : lit) picture.stats.lighting_evaluations += n;
    return picture;
}

}  // namespace rakelight::raster
