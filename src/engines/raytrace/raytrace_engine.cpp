// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/raytrace_engine.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <utility>

#include <rakelight_internal/base/text.h>

#include "base/format_text.h"
#include "cpu_shading/environment_maps.h"
#include "cpu_shading/scratch_pool.h"
#include "cpu_shading/textures.h"
#include "engines/raytrace/paths/path_render.h"
#include "engines/raytrace/tiles.h"
#include "math/flush_denormals.h"
#include "math/isa.h"
#include "scene/validate.h"

namespace rakelight::raytrace {
namespace {

void add(const RayStats& from, RayStats& to) {
    to.primary += from.primary, to.shadow += from.shadow;
    to.reflected += from.reflected, to.refracted += from.refracted, to.dropped += from.dropped;
    to.deepest = std::max(to.deepest, from.deepest);
}

/// Before hours go by: as many rays as there can be.
void check_naive(const NaiveScan& naive, const RenderSettings& settings, const Window& window,
                 const std::vector<Light>& lights) {
    const auto shadows = std::ranges::count_if(lights, [&](const Light& light) {
        return settings.shadows && light.casts_shadow && light.type != LightType::ambient;
    });
    const double pixels = double(window.width) * window.height,
                 passes = (settings.colors ? settings.samples : 0) + (settings.channels != 0 ? 1 : 0);
    const double rays = pixels * passes * double(1 + shadows), tests = rays * double(naive.surfaces());
    constexpr double tests_a_second = 2e8;  // of one thread, about
    if (tests <= settings.naive_limit) return;
    const double seconds = tests / tests_a_second;
    const auto [time, unit] = seconds < 120    ? std::pair(seconds, "seconds")
                              : seconds < 7200 ? std::pair(seconds / 60, "minutes")
                                               : std::pair(seconds / 3600, "hours");
    char text[160];
    std::snprintf(text, sizeof text, "up to %.3g rays and %llu surfaces are %.3g tests, about %.3g %s of one processor",
                  rays, static_cast<unsigned long long>(naive.surfaces()), tests, time, unit);
    throw Error(ErrorCode::usage, text, {}, "make the picture smaller, or 'naive-limit' higher")
        .about("naive", {"naive-limit"});
}

Window whole(const RenderSettings& s) { return s.window == Window{} ? Window{0, 0, s.width, s.height} : s.window; }

class RaytraceEngine final : public Engine {
public:
    RaytraceEngine() : isa_(isa_from_environment()), kernels_(*RL_BY_ISA(isa_, kernels())), rays_(isa_) {}

    std::string name() const override { return "trace"; }
    EngineCapabilities capabilities() const override {
        return {.channels = channels_all,
                .samples = {1, 4, 8},
                .lines_and_points = true,
                .shadows = true,
                .rays = true,
                .path_channels = channels_of_paths,
                .progressive = true};
    }

    void prepare(Scene scene, Context& context) override {
        validate_changes(scene, list_.scene);
        path_lights_.reset();
        list_ = {};  // what fails from here on leaves an empty scene
        try {
            cpu_shading::DrawList list = cpu_shading::make_draw_list(std::move(scene), textures_, context);
            cpu_shading::set_environment(list.scene, environments_, true, list.views, context);
            rays_.set(list, context);
            list_ = std::move(list);
        } catch (...) {
            rays_.clear();
            throw;
        }
    }
    const Scene& scene() const override { return list_.scene; }
    void set_lights(std::vector<Light> lights) override {
        validate_lights(lights, list_.scene.nodes.size());
        list_.scene.lights = std::move(lights);
    }

    RenderStats render(const Camera& camera, const RenderSettings& asked, Sink& sink, Context& context) override {
        const bool is_path = asked.method == RayMethod::path;
        const RenderSettings settings = is_path ? path_settings(asked) : asked;
        const shading::PictureCamera view = shading::picture_camera_of(list_, camera, settings);
        TracePicture picture(list_, rays_, view, settings, kernels_, context);
        const Window window = whole(settings);
        std::optional<NaiveScan> naive;
        if (settings.naive) {
            naive.emplace(list_, rays_, context);
            check_naive(*naive, settings, window, list_.scene.lights);
            picture.naive = &*naive;
        }
        if (!is_path) note_rough_glass(settings, context.report());
        sink.begin(settings.width, settings.height, window, settings.channels);
        const auto begin = std::chrono::steady_clock::now();
        RayStats passes;
        if (is_path && settings.colors) {
            passes = follow_paths(picture, window, sink, context);
        } else {
            trace(picture, window, sink, context);
            sink.end_pass(0);
        }
        RenderStats stats = take_counts(passes, context.report());
        if (naive) stats.rays.triangle_tests = naive->tests();
        stats.times.tiles = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return stats;
    }

private:
    /// Of all threads since the last call.
    RenderStats take_counts(const RayStats& passes, Report& report) {
        RayCounts counts;
        const auto take = [&counts](TileScratch& scratch) {
            const RayCounts c = std::exchange(scratch.counts, {});
            counts.shaded += c.shaded, counts.marked += c.marked, counts.not_finite += c.not_finite;
            add(c.rays, counts.rays);
        };
        pool_.for_each(take), path_pool_.for_each(take);
        RenderStats stats;
        stats.pixels_shaded = stats.lighting_evaluations = counts.shaded;
        stats.pixels_marked = counts.marked;
        stats.pixels_not_finite = counts.not_finite;
        stats.rays = counts.rays;
        stats.rays.passes = passes.passes, stats.rays.samples = passes.samples, stats.rays.noise = passes.noise;
        stats.rays.scene_bytes = rays_.tree_bytes_used();
        if (counts.rays.dropped > 0)
            report.add(Remark::warning, list_.scene.source, {},
                       std::to_string(counts.rays.dropped) +
                           " reflections and refractions were left out: too many in one pixel",
                       {"max-depth"});
        if (counts.not_finite > 0)
            report.add(Remark::warning, list_.scene.source, {},
                       std::to_string(counts.not_finite) + " color values were not finite and are shown black");
        return stats;
    }

    void note_rough_glass(const RenderSettings& settings, Report& report) const {
        if (settings.method == RayMethod::cast || settings.max_depth == 0) return;
        const auto is_rough = [](const shading::DrawMaterial& m) {
            const shading::MaterialFactors& f = m.factors;
            return m.is_drawn && f.metallic_roughness && f.transmission > 0 && f.roughness > shading::widest_mirror;
        };
        if (std::ranges::any_of(list_.materials, is_rough))
            report.add(Remark::note, list_.scene.source, {}, "light is not scattered by rough glass");
    }

    /// In strips of as many rows as the sink takes.
    void trace(const TracePicture& picture, const Window& window, Sink& sink, Context& context) {
        const int most = sink.rows_at_once() > 0 ? sink.rows_at_once() : window.height;
        for (int y = 0; y < window.height; y += most) {
            const Window strip{window.x, window.y + y, window.width, std::min(most, window.height - y)};
            trace_strip(picture, window, strip, sink, context);
            context.throw_if_cancelled();
            sink.rows_done(strip.y, strip.height);
        }
    }

    void trace_strip(const TracePicture& picture, const Window& window, const Window& strip, Sink& sink,
                     Context& context) {
        for_tiles(strip, context, [&](const Window& area, double share) {
            const FlushDenormals guard;
            auto scratch = pool_.take();
            trace_tile(picture, area, context, *scratch);
            if (!context.cancelled()) sink.tile(tile_of(area, picture.settings.channels, *scratch));
            pool_.give_back(std::move(scratch));
            context.progress("render", (strip.y - window.y + strip.height * share) / window.height);
        });
    }

    RayStats follow_paths(const TracePicture& picture, const Window& window, Sink& sink, Context& context) {
        const FrontFace front = picture.settings.front_face;
        if (!path_lights_ || path_lights_->front_face != front)
            path_lights_ = make_path_lights(list_, textures_, front, context);
        const PathLights lights(*path_lights_, picture);
        PathPicture paths{
            picture, lights, {}, picture.settings.paths.denoise || (picture.settings.channels & channel_albedo) != 0};
        for (std::uint32_t d = 0; d < list_.draws.size(); ++d)
            paths.shines_behind.push_back(path_lights_->emitters.shines_back(d));
        paths.has_dispersion = std::ranges::any_of(
            list_.materials, [](const shading::DrawMaterial& m) { return m.factors.dispersion > 0; });
        paths.shines = lights.has_sky() || !picture.marks.empty() ||
                       std::ranges::any_of(list_.materials, [](const shading::DrawMaterial& m) {
                           return shading::emits(m) || m.factors.unlit != 0;
                       });
        note_paths(picture, context.report());
        const auto is_dark = [](const Light& light) { return light.type == LightType::ambient; };
        if (!paths.shines && std::ranges::all_of(list_.scene.lights, is_dark))
            context.report().add(
                Remark::warning, list_.scene.source, {},
                "there is no source of light: no lights, no emissive surfaces, and no environment lighting");
        const RayStats stats = render_paths(paths, window, sink, context, path_pool_);
        const PathSettings& asked = picture.settings.paths;
        if (asked.noise > 0 && asked.max_seconds == 0 && stats.noise > asked.noise) {
            char text[120];
            std::snprintf(text, sizeof text, "the estimated error is %.3g after all %d samples, not %.3g", stats.noise,
                          stats.samples, asked.noise);
            context.report().add(Remark::warning, list_.scene.source, {}, text, {"samples"});
        }
        return stats;
    }

    void note_paths(const TracePicture& picture, Report& report) const {
        const auto is_ambient = [](const Light& light) {
            return light.type == LightType::ambient || light.ambient != vec3{};
        };
        if (std::ranges::any_of(list_.scene.lights, is_ambient))
            report.add(Remark::note, list_.scene.source, {},
                       "ambient light is left out: paths compute the light that it approximates");
        const auto has_occlusion = [](const Material& m) { return m.occlusion_texture && m.occlusion_strength > 0; };
        if (std::ranges::any_of(list_.scene.materials, has_occlusion))
            report.add(Remark::note, list_.scene.source, {}, "occlusion maps are left out: paths compute occlusion");
        std::vector<bool> is_too_bright(list_.materials.size());
        for (std::uint32_t d = 0; d < list_.draws.size(); ++d)
            if (may_reflect_too_much(picture.hit_job(d))) is_too_bright[list_.draws[d].material] = true;
        const auto count = std::ranges::count(is_too_bright, true);
        if (count > 0)
            report.add(Remark::note, list_.scene.source, {},
                       format_text("where the classical colors of {} would reflect more light than arrives, they are "
                                   "divided by their sum",
                                   counted(std::uint64_t(count), "material")));
    }

    static bool may_reflect_too_much(const HitJob& job) {
        const cpu_shading::MaterialView& m = *job.material;
        if (m.metallic_roughness != 0 || m.unlit != 0 || job.unlit != 0) return false;
        const bool has_gloss = !shading::is_matte(job.reflection_model);
        for (std::size_t c = 0; c < 3; ++c)
            if (m.base_color[c] + (has_gloss ? m.specular[c] : 0) + m.filter[c] > 1) return true;
        return false;
    }

    Isa isa_;
    const Kernels& kernels_;
    shading::TextureCache textures_;
    shading::EnvironmentCache environments_;
    cpu_shading::DrawList list_;
    RayScene rays_;
    cpu_shading::ScratchPool<TileScratch> pool_;
    cpu_shading::ScratchPool<PathScratch> path_pool_;
    std::unique_ptr<ScenePathLights> path_lights_;  ///< of list_; null: not made yet
};

}  // namespace

std::unique_ptr<Engine> make_engine() { return std::make_unique<RaytraceEngine>(); }

}  // namespace rakelight::raytrace
