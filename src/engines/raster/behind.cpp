// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/behind.h"

#include "cpu_shading/scratch_pool.h"
#include "engines/raster/draw_tile.h"
#include "engines/raster/material_jobs.h"
#include "math/flush_denormals.h"
#include "shading/behind.h"

namespace rakelight::raster {
namespace {

void draw_tiles(const TileJob& job, Sink& sink, Context& context) {
    cpu_shading::ScratchPool<TileScratch> pool;
    context.parallel_for(job.grid.count(), [&](std::size_t tile) {
        const FlushDenormals guard;
        auto scratch = pool.take();
        draw_tile(job, tile, *scratch, sink);
        pool.give_back(std::move(scratch));
    });
    context.throw_if_cancelled();
}

}  // namespace

std::unique_ptr<const cpu_shading::BehindPicture> picture_behind(const BehindJob& of, Context& context) {
    if (!shading::needs_behind(of.list, of.settings)) return nullptr;
    // Its remarks are the picture's.
    Context quiet({.threads = context.threads(), .max_memory = context.memory().limit(), .parent = &context});
    const PictureCamera view = shading::camera_behind(of.view);
    const RenderSettings settings = shading::settings_behind(of.settings, view);
    auto picture = std::make_unique<cpu_shading::BehindPicture>(view, context);
    const TileGrid grid(settings.width, settings.height, {});
    FrontEnd front{.list = of.list,
                   .view = view,
                   .settings = settings,
                   .kernels = of.geometry_kernels,
                   .memory = PictureMemory(context.memory()),
                   .only_behind = true};
    transform_draws(front, quiet);
    const Binned binned = set_up_and_bin(front, grid, {}, quiet);
    make_material_jobs(front, {.shadows = of.shadows});
    const LightPoints points = light_points(front, binned, of.lights, of.kernels, {}, quiet);
    const Marks marks = make_marks(front, grid, quiet);
    const LightReach reach(of.lights);
    TileJob job{front, binned, grid, of.lights, of.kernels, false, points};
    job.marks = &marks, job.context = &quiet;
    job.reach = reach.is_worth_it() ? &reach : nullptr;
    draw_tiles(job, *picture, quiet);
    picture->finish(quiet);
    return picture;
}

}  // namespace rakelight::raster
