// SPDX-License-Identifier: Apache-2.0
// The soft engine's way of the data: draw list -> vertices -> triangles in tiles -> visibility -> shading -> sink.
#include "engines/raster/raster_engine.h"

#include <atomic>
#include <mutex>

#include "engines/raster/tile.h"
#include "math/flush_denormals.h"
#include "math/isa.h"
#include "math/linear.h"

namespace rakelight::raster {
namespace {

const Kernels* kernels_for(Isa isa) {
    switch (isa) {
        case Isa::scalar: return scalar::kernels();
        case Isa::sse2: return sse2::kernels();
        case Isa::avx2: return avx2::kernels();
        case Isa::avx512: return avx512::kernels();
    }
    return scalar::kernels();
}

/// Working memory of tiles, handed from one to the next.
class ScratchPool {
public:
    std::unique_ptr<TileScratch> take() {
        const std::lock_guard lock(mutex_);
        if (free_.empty()) return std::make_unique<TileScratch>();
        auto scratch = std::move(free_.back());
        free_.pop_back();
        return scratch;
    }
    void give_back(std::unique_ptr<TileScratch> scratch) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(scratch));
    }

private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<TileScratch>> free_;
};

/// The part of a finished tile that lies in the window, as the sink wants it.
struct Delivery {
    std::vector<vec4> color;
    std::vector<float> depth;
    std::vector<vec3> normal;
    std::vector<std::uint32_t> object, material;
};

float distance_of(float key, const View& view) {
    if (!(key >= 0)) return std::numeric_limits<float>::infinity();
    if (view.orthographic) return float(view.near + (1 - double(key)) * (view.far - view.near));
    return key > 0 ? float(view.near / double(key)) : std::numeric_limits<float>::infinity();
}

void deliver(const TileJob& job, std::size_t tile, const TileScratch& s, Sink& sink) {
    const Window area = job.grid.pixels(tile);
    const std::uint32_t channels = job.front.settings.channels;
    Delivery d;
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x) {
            const auto p = std::size_t((y - job.grid.origin_y(tile)) * tile_size + x - job.grid.origin_x(tile));
            d.color.push_back(s.color[p]);
            if (channels & channel_depth) d.depth.push_back(distance_of(s.depth[p], job.front.view));
            if (channels & channel_normal) d.normal.push_back(s.normal[p]);
            if (channels & channel_object) d.object.push_back(s.object[p]);
            if (channels & channel_material) d.material.push_back(s.material[p]);
        }
    sink.tile({area, d.color, d.depth, d.normal, d.object, d.material, {}});
}

class SoftEngine final : public Engine {
public:
    SoftEngine() : kernels_(kernels_for(isa_from_environment())) {}

    std::string name() const override { return "soft"; }

    void prepare(const Scene& scene, Context& context) override { list_ = make_draw_list(scene, textures_, context); }

    RenderStats render(const Camera& camera, const RenderSettings& settings, Sink& sink, Context& context) override {
        if (settings.shading == Shading::flat || settings.shading == Shading::gouraud)
            throw Error(ErrorCode::usage, "the soft engine shades per pixel (phong) or not at all (unlit)", {},
                        "for a faceted look use --normals flat");
        const View view = make_view(camera, camera_to_world(list_.scene, camera, list_.node_to_world), settings);
        const TileGrid grid(settings.width, settings.height, settings.window);
        FrontEnd front{list_, view, settings, {}, {}, {}, PictureMemory(context.memory())};
        transform_draws(front, context);
        const Binned binned = set_up_and_bin(front, grid, context);
        const std::vector<lighting::LightParameters> lights = make_lights(list_.scene, list_.node_to_world, view.camera_to_world[3].xyz());
        sink.begin(settings.width, settings.height, grid.window, settings.channels);
        draw_tiles({front, binned, grid, lights, *kernels_}, sink, context, front.stats);
        sink.end_pass(0);
        return front.stats;
    }

private:
    void draw_tiles(const TileJob& job, Sink& sink, Context& context, RenderStats& stats) {
        std::atomic<std::uint64_t> covered{0}, shaded{0}, not_finite{0};
        std::atomic<std::size_t> done{0};
        context.parallel_for(job.grid.count(), [&](std::size_t tile) {
            const FlushDenormals guard;
            if (context.cancelled()) return;
            auto scratch = pool_.take();
            scratch->covered = scratch->shaded = scratch->not_finite = 0;
            find_visible(job, tile, *scratch);
            shade_opaque(job, tile, *scratch);
            blend_transparent(job, tile, *scratch);
            deliver(job, tile, *scratch, sink);
            covered += scratch->covered;
            shaded += scratch->shaded;
            not_finite += scratch->not_finite;
            pool_.give_back(std::move(scratch));
            context.progress("render", double(++done) / double(job.grid.count()));
        });
        context.throw_if_cancelled();
        stats.pixels_covered = covered;
        stats.pixels_shaded = shaded;
        stats.pixels_not_finite = not_finite;
        if (not_finite > 0)
            context.report().add(Remark::warning, list_.scene.source, {}, std::to_string(not_finite) + " color values came out not finite and are shown black");
    }

    const Kernels* kernels_;
    TextureCache textures_;
    DrawList list_;
    ScratchPool pool_;
};

}  // namespace

std::unique_ptr<Engine> make_engine() { return std::make_unique<SoftEngine>(); }

std::string isa_name() { return name(isa_from_environment()); }

}  // namespace rakelight::raster
