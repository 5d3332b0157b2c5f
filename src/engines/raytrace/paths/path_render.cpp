// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/paths/path_render.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "engines/raytrace/tiles.h"
#include "image/denoise.h"
#include "math/flush_denormals.h"

namespace rakelight::raytrace {
namespace {

constexpr int most_in_pass = 16;                          ///< samples
constexpr int fewest_for_noise = 16;                      ///< samples, before the estimated error is believed
constexpr std::size_t denoised_bytes = 6 * sizeof(vec3);  ///< of a pixel: what the denoiser reads and writes

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Passes of 1, 1, 2, 4, 8, 16, 16, ... samples.
int samples_of_next_pass(int done, int wanted) { return std::min({std::max(done, 1), most_in_pass, wanted - done}); }

/// With a border, so that a denoised window is that of the whole picture.
Window film_window(const Window& w, const RenderSettings& s) {
    if (!s.paths.denoise) return w;
    const int left = std::max(w.x - denoise_radius, 0), top = std::max(w.y - denoise_radius, 0);
    return {left, top, std::min(w.x + w.width + denoise_radius, s.width) - left,
            std::min(w.y + w.height + denoise_radius, s.height) - top};
}

class PathRender {
public:
    PathRender(const PathPicture& picture, const Window& window, Sink& sink, Context& context,
               cpu_shading::ScratchPool<PathScratch>& pool)
        : picture_(picture),
          settings_(picture.trace.settings),
          window_(window),
          sink_(sink),
          context_(context),
          pool_(pool),
          film_(film_window(window, settings_), picture.wants_guides, context) {
        const std::size_t pixels = std::size_t(film_.window().width) * std::size_t(film_.window().height);
        if (settings_.paths.denoise) charge_ = MemoryCharge(context.memory(), pixels * denoised_bytes, "the denoiser");
    }

    RayStats run() {
        while (film_.samples() < settings_.samples && !context_.cancelled() && !is_enough()) {
            const int count = samples_of_next_pass(film_.samples(), settings_.samples);
            try {
                follow(count);
            } catch (const Error&) {
                if (!context_.cancelled()) throw;
            }
            if (context_.cancelled()) break;  // what is there may be wanted
            film_.end_pass(count);
            ++stats_.passes;
            if (!is_of_strips()) deliver_pass();
        }
        stats_.samples = film_.samples(), stats_.noise = film_.noise();
        if (film_.samples() > 0 && !context_.cancelled()) finish(context_);
        if (film_.samples() > 0 && context_.cancelled() && is_of_strips() && sink_.wants_partial()) {
            char text[120];
            std::snprintf(text, sizeof text, "stopped after %d of %d samples per pixel, estimated error %.3g",
                          stats_.samples, settings_.samples, stats_.noise);
            context_.report().add(Remark::warning, picture_.trace.list.scene.source, {}, text);
            Context rest({.threads = context_.threads()});
            finish(rest);
        }
        context_.throw_if_cancelled();
        return stats_;
    }

private:
    /// What comes behind the last pass.
    void finish(Context& context) {
        try {
            if (settings_.paths.denoise && !is_denoised_) denoise(context);
            if (is_of_strips()) deliver_strips(context);
        } catch (const Error&) {
            if (!context.cancelled()) throw;
        }
    }

    bool is_of_strips() const { return sink_.rows_at_once() > 0; }

    /// Whether no further pass is to begin.
    bool is_enough() const {
        const PathSettings& s = settings_.paths;
        if (film_.samples() == 0) return false;
        const double noise = s.noise > 0 && film_.samples() >= fewest_for_noise ? film_.noise() : 0;
        if (noise > 0 && noise < s.noise) return true;
        if (!(s.max_seconds > 0)) return false;
        const double a_sample = seconds_since(begin_) / film_.samples();
        return seconds_since(begin_) + a_sample * samples_of_next_pass(film_.samples(), settings_.samples) >
               s.max_seconds;
    }

    /// Once more to sinks that have had the last pass.
    void denoise(Context& context) {
        const PathFilm::Guided g = film_.guided();
        std::vector<vec3> out(g.color.size());
        denoise_into({film_.window().width, film_.window().height, g.color, g.variance, g.albedo, g.normal, g.position},
                     out, context);
        film_.replace_colors(std::move(out));
        is_denoised_ = true;
        ++stats_.passes;
        if (!is_of_strips()) deliver_pass();
    }

    /// The error falls with the root of the samples.
    double expected_samples() const {
        const double noise = film_.noise(), wanted = settings_.paths.noise, ratio = noise / wanted;
        const double enough = wanted > 0 && noise > 0 ? film_.samples() * ratio * ratio : settings_.samples;
        return std::min(std::max(enough, 1.0 * fewest_for_noise), 1.0 * settings_.samples);
    }
    double share_of_time() const {
        const double most = settings_.paths.max_seconds;
        return most > 0 ? seconds_since(begin_) / most : 0;
    }

    void follow(int count) {
        const int first = film_.samples();
        const double all = expected_samples(), before = first / all, share = count / all;
        for_tiles(film_.window(), context_, [&](const Window& area, double done) {
            const FlushDenormals guard;
            auto scratch = pool_.take();
            follow_paths(picture_, area, first, first + count, context_, *scratch, film_);
            pool_.give_back(std::move(scratch));
            context_.progress("render", std::min(std::max(before + share * done, share_of_time()), 1.0));
        });
    }

    void deliver(const Window& area, const Context& context) {
        const FlushDenormals guard;
        auto scratch = pool_.take();
        PathScratch& s = *scratch;
        const std::uint32_t asked = settings_.channels;
        const std::size_t count = std::size_t(area.width) * std::size_t(area.height);
        s.color.resize(count);
        if (asked != 0) find_data(picture_.trace, area, context, s);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t pixel = film_.pixel_at(area.x + int(i) % area.width, area.y + int(i) / area.width);
            s.color[i] = film_.color(pixel, settings_.background);
            if (asked & channel_albedo) s.albedo[i] = film_.albedo(pixel);
            if (asked & channel_direct) s.direct[i] = film_.direct(pixel);
            if (asked & channel_indirect) s.indirect[i] = film_.indirect(pixel);
            if (asked & channel_variance) s.variance[i] = film_.variance(pixel);
        }
        Tile tile = tile_of(area, asked, s);
        s.sample_counts.assign(count, std::uint16_t(std::min(film_.samples(), 65535)));
        tile.samples = s.sample_counts;
        sink_.tile(tile);
        pool_.give_back(std::move(scratch));
    }

    void deliver_pass() {
        for_tiles(window_, context_, [&](const Window& area, double) { deliver(area, context_); });
        sink_.end_pass(stats_.passes - 1);
    }

    void deliver_strips(const Context& context) {
        const int most = sink_.rows_at_once();
        for (int y = 0; y < window_.height; y += most) {
            const Window strip{window_.x, window_.y + y, window_.width, std::min(most, window_.height - y)};
            for_each_tile(strip, [&](const Window& area) { deliver(area, context); });
            context.throw_if_cancelled();
            sink_.rows_done(strip.y, strip.height);
        }
        sink_.end_pass(0);
    }

    const PathPicture& picture_;
    const RenderSettings& settings_;
    Window window_;
    Sink& sink_;
    Context& context_;
    cpu_shading::ScratchPool<PathScratch>& pool_;
    PathFilm film_;
    MemoryCharge charge_;
    bool is_denoised_ = false;
    RayStats stats_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

RenderSettings path_settings(RenderSettings settings) {
    settings.specular_form = SpecularForm::normalized;
    settings.tangent_space = TangentSpace::world;
    settings.shadows = true;
    settings.viewer_at_infinity = false;
    settings.specular_horizon = true;
    return settings;
}

RayStats render_paths(const PathPicture& picture, const Window& window, Sink& sink, Context& context,
                      cpu_shading::ScratchPool<PathScratch>& pool) {
    return PathRender(picture, window, sink, context, pool).run();
}

}  // namespace rakelight::raytrace
