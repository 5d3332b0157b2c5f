// SPDX-License-Identifier: Apache-2.0
// The soft engine's way of the data: draw list -> vertices -> triangles in tiles -> visibility -> shading -> sink.
#include "engines/raster/raster_engine.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>

#include "cpu_shading/scratch_pool.h"
#include "engines/raster/behind.h"
#include "engines/raster/draw_tile.h"
#include "engines/raster/material_jobs.h"
#include "engines/raster/occlusion/occlusion.h"
#include "engines/raster/shade/blended_layers.h"
#include "engines/raster/shadows/shadow_maps.h"
#include "engines/raster/shadows/shadow_texels.h"
#include "engines/raster/tile.h"
#include "engines/raster/visibility/visibility_methods.h"
#include "math/flush_denormals.h"
#include "math/isa.h"
#include "math/linear.h"
#include "scene/validate.h"
#include "shading/lights/lights.h"
#include "shading/remarks/open_surfaces.h"

namespace rakelight::raster {

namespace avx512 {
[[maybe_unused]] static const Kernels* kernels() { return avx512x2::kernels(); }  // pairs of vectors are faster there
}  // namespace avx512

namespace {

/// What the tiles of this picture took, and begins anew. When no scratch is out.
void add_times(cpu_shading::ScratchPool<TileScratch>& pool, StageTimes& sum) {
    pool.for_each([&sum](TileScratch& scratch) {
        const StageTimes t = std::exchange(scratch.times, {});
        sum.visibility += t.visibility;
        sum.shading += t.shading;
        sum.blending += t.blending;
        sum.delivery += t.delivery;
    });
}

/// No triangles in any tile.
Binned nothing(const TileGrid& grid) {
    Binned binned;
    binned.offsets.assign(grid.count() + 1, 0);
    binned.run_offsets = binned.offsets;
    return binned;
}

/// The row of tiles that a strip which begins with row `first` ends before, so that it has at most `rows` rows of
/// pixels (0: all).
int strip_end(const TileGrid& grid, int first, int rows) {
    if (rows == 0) return grid.rows;
    const int top = grid.pixels(grid.first_of_row(first)).y;
    int end = first + 1;
    for (; end < grid.rows; ++end) {
        const Window next = grid.pixels(grid.first_of_row(end));
        if (next.y + next.height - top > rows) break;
    }
    return end;
}

class SoftEngine final : public Engine {
public:
    SoftEngine()
        : kernels_(RL_BY_ISA(isa_from_environment(), kernels())),
          geometry_kernels_(RL_BY_ISA(isa_from_environment(), geometry_kernels())) {}

    std::string name() const override { return "soft"; }

    EngineCapabilities capabilities() const override {
        return {.channels = channels_all | channel_ambient_occlusion,
                .samples = {1, 4, 8},
                .visibility_methods = true,
                .screen_interpolation = true,
                .lines_and_points = true,
                .shadows = true,
                .ambient_occlusion = true};
    }

    void prepare(Scene scene, Context& context) override {
        validate_changes(scene, list_.scene);
        list_ = {};  // its textures may go: what fails from here on leaves an empty scene
        // First: maps are not there beside the new scene's textures, nor of lights that a list left half made lacks.
        shadows_.forget();
        open_surfaces_.forget();
        list_ = cpu_shading::make_draw_list(std::move(scene), textures_, context);
        cpu_shading::set_environment(list_.scene, environments_, false, list_.views, context);
    }

    const Scene& scene() const override { return list_.scene; }

    void set_lights(std::vector<Light> lights) override {
        validate_lights(lights, list_.scene.nodes.size());
        if (lights == list_.scene.lights) return;
        list_.scene.lights = std::move(lights);
        shadows_.forget();
    }

    RenderStats render(const Camera& camera, const RenderSettings& wanted, Sink& sink, Context& context) override {
        const RenderSettings settings = settings_for_method(wanted);
        const PictureCamera view = picture_camera_of(list_, camera, settings);
        StageClock clock;
        kept_ = {};  // counted again
        const TileGrid grid(settings.width, settings.height, settings.window);
        FrontEnd front{list_,
                       view,
                       settings,
                       *geometry_kernels_,
                       std::move(clip_store_),
                       std::move(screen_store_),
                       {},
                       {},
                       PictureMemory(context.memory())};
        transform_draws(front, context);
        Binned binned = settings.surfaces ? set_up_and_bin(front, grid, std::move(binned_), context) : nothing(grid);
        const dvec3 eye = view.camera_to_world[3].xyz();
        std::vector<lighting::LightParameters> lights = shading::make_lights(list_.scene, list_.node_to_world, eye);
        shadows_.update(list_, settings, *kernels_, *geometry_kernels_, eye, lights, context);
        front.stats.shadow_maps = shadows_.count();
        front.stats.shadow_bytes = shadows_.bytes();
        ShadowTexels shadow_texels(grid);
        const LightReach reach(lights);
        const auto behind =
            picture_behind({list_, view, settings, lights, shadows_.data(), *kernels_, *geometry_kernels_}, context);
        make_material_jobs(front, {.shadows = shadows_.data(), .behind = behind ? behind->view() : nullptr});
        LightPoints points = light_points(front, binned, lights, *kernels_, std::move(points_), context);
        const Marks marks = make_marks(front, grid, context);
        front.stats.times.front_end = clock.lap();
        sink.begin(settings.width, settings.height, grid.window, settings.channels);
        const bool has_blended = std::any_of(list_.materials.begin(), list_.materials.end(),
                                             [](const DrawMaterial& m) { return m.factors.blend != 0; });
        std::optional<AmbientOcclusion> occlusion;
        if (settings.ambient_occlusion && settings.surfaces) occlusion.emplace(front, binned, grid, *kernels_, context);
        const double waited = draw_tiles(
            {front, binned, grid, lights, *kernels_, has_blended, points, sink.wants_srgb8(),
             (settings.channels & channel_uv1) != 0, &marks, &context, reach.is_worth_it() ? &reach : nullptr,
             shadows_.data() ? &shadow_texels : nullptr, occlusion ? &*occlusion : nullptr},
            sink, occlusion, context, front.stats);
        sink.end_pass(0);
        front.stats.times.tiles = clock.lap() - waited;
        open_surfaces_.remark(list_, front.culled_by_side, settings.cull, wanted.cull == Cull::back, context);
        shadow_texels.remark(list_.scene, lights, shadows_.data(), context);
        front.memory.remove(front.jobs.size() * sizeof(MaterialJob));  // of this picture alone
        kept_ = front.memory.take();
        clip_store_ = std::move(front.clip_store);
        screen_store_ = std::move(front.screen_store);
        binned_ = std::move(binned);
        points_ = std::move(points);
        return front.stats;
    }

private:
    /// @return [s] what the sink did with finished strips
    double draw_tiles(const TileJob& job, Sink& sink, std::optional<AmbientOcclusion>& occlusion, Context& context,
                      RenderStats& stats) {
        std::atomic<std::uint64_t> covered{0}, shaded{0}, not_finite{0}, marked{0}, lit_pixels{0}, depth_passes{0},
            samples_covered{0}, layers_unsorted{0};
        std::atomic<std::size_t> done{0};
        const auto draw = [&](std::size_t tile) {
            const FlushDenormals guard;
            if (context.cancelled()) return;
            auto scratch = pool_.take();
            scratch->covered = scratch->shaded = scratch->not_finite = scratch->marked = scratch->lit_pixels =
                scratch->depth_passes = scratch->samples_covered = scratch->layers_unsorted = 0;
            draw_tile(job, tile, *scratch, sink);
            covered += scratch->covered;
            shaded += scratch->shaded;
            not_finite += scratch->not_finite;
            marked += scratch->marked;
            lit_pixels += scratch->lit_pixels;
            depth_passes += scratch->depth_passes;
            samples_covered += scratch->samples_covered;
            layers_unsorted += scratch->layers_unsorted;
            pool_.give_back(std::move(scratch));
            context.progress("render", double(++done) / double(job.grid.count()));
        };
        double waited = 0;
        const int at_once = sink.rows_at_once();
        for (int row = 0; row < job.grid.rows;) {
            const int end = strip_end(job.grid, row, at_once);
            const std::size_t first = job.grid.first_of_row(row);
            const Window top = job.grid.pixels(first), bottom = job.grid.pixels(job.grid.first_of_row(end) - 1);
            const int height = bottom.y + bottom.height - top.y;
            StageClock clock;
            if (occlusion) occlusion->draw_depths({job.grid.window.x, top.y, job.grid.window.width, height}, context);
            stats.times.occlusion += clock.lap();
            context.parallel_for(job.grid.first_of_row(end) - first, [&](std::size_t i) { draw(first + i); });
            context.throw_if_cancelled();
            clock.lap();
            sink.rows_done(top.y, height);
            waited += clock.lap();
            row = end;
        }
        add_times(pool_, stats.times);
        stats.pixels_covered = covered;
        stats.pixels_shaded = shaded;
        stats.pixels_not_finite = not_finite;
        stats.pixels_marked = marked;
        stats.lighting_evaluations += lit_pixels;
        stats.depth_passes = depth_passes;
        stats.samples_covered = samples_covered;
        if (not_finite > 0)
            context.report().add(Remark::warning, list_.scene.source, {},
                                 std::to_string(not_finite) + " color values were not finite and are shown black");
        if (layers_unsorted > 0) remark_on_layers(layers_unsorted, context);
        return waited;
    }

    void remark_on_layers(std::uint64_t count, Context& context) const {
        context.report().add(Remark::warning, list_.scene.source, {},
                             std::to_string(count) +
                                 " times a blended surface was laid over nearer ones, because more than " +
                                 std::to_string(BlendedLayers::most_waiting) +
                                 " lie over one pixel out of order; the engine trace sorts any number");
    }

    const Kernels* kernels_;
    const GeometryKernels* geometry_kernels_;
    shading::TextureCache textures_;
    shading::EnvironmentCache environments_;
    DrawList list_;
    shading::OpenSurfaces open_surfaces_;
    ShadowMaps shadows_;
    cpu_shading::ScratchPool<TileScratch> pool_;
    // Memory of the picture before, used again, and what pays for it.
    MemoryCharge kept_;
    std::vector<ClipVertex> clip_store_;
    std::vector<ScreenVertex> screen_store_;
    Binned binned_;
    LightPoints points_;
};

}  // namespace

std::unique_ptr<Engine> make_engine() { return std::make_unique<SoftEngine>(); }

std::string isa_name() { return name(isa_from_environment()); }

}  // namespace rakelight::raster
