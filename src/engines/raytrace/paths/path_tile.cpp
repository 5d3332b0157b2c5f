// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/paths/path_tile.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engines/empty_pixel.h"
#include "engines/raytrace/paths/path_hits.h"
#include "math/linear.h"

namespace rakelight::raytrace {
namespace {

/// Rays through a random place of every pixel, without differentials: maps are read at their finest, and the pixel's mean is that of
/// its paths.
void make_path_rays(const TracePicture& picture, const Window& area, std::uint32_t sample, PathScratch& s) {
    const shading::PictureCamera& view = picture.view;
    const shading::PixelRays rays = shading::pixel_rays(view, area.x, area.y);
    RayWave& wave = s.wave;
    wave.count = std::size_t(area.width) * std::size_t(area.height), wave.stride = plane_stride;
    wave.planes.assign(std::size_t(ray_planes) * plane_stride, 0.0f);
    wave.pixel.clear(), wave.weight.clear(), wave.media.clear();
    const dvec3 ahead = -view.camera_to_world[2].xyz();
    for (std::size_t i = 0; i < wave.count; ++i) {
        const auto numbers = s.numbers[i].of(sample, group_of_pixel);
        const dvec3 at = rays.at(double(i % std::size_t(area.width)) + unit_double(numbers[0]) - 0.5,
                                 double(i / std::size_t(area.width)) + unit_double(numbers[1]) - 0.5);
        const dvec3 origin = view.orthographic ? at : dvec3{}, direction = view.orthographic ? ahead : at;
        for (std::size_t c = 0; c < 3; ++c) {
            wave.plane(ray_o + std::int32_t(c))[i] = float(origin[c]);
            wave.plane(ray_d + std::int32_t(c))[i] = float(direction[c]);
        }
    }
}

/// What lies behind all surfaces, for the rays that have met none.
void lay_behind(const PathPicture& picture, int depth, PathScratch& s) {
    const TracePicture& trace = picture.trace;
    const bool has_picture = trace.list.views.environment != nullptr;
    const bool is_shown = has_picture && trace.list.scene.environment->is_background;
    const vec3 plain = light_of_background(trace.settings) * trace.settings.background.w;
    if (has_picture) find_sky_colors(trace, false, s);
    for (std::size_t i = 0; i < s.wave.count; ++i) {
        if (s.meetings[i].draw != no_index) continue;
        const PathState& state = s.states[i];
        PathSample& to = s.brought[s.wave.pixel_of(i)];
        const vec3 weight = (s.wave.is_primary() ? vec3{1, 1, 1} : s.wave.weight[i]) * state.through;
        const bool has_met_none = depth == 0 && to.alpha == 0;
        if (has_picture && (is_shown || (depth > 0 && picture.lights.has_sky()))) {
            const vec3 direction = s.wave.vector(ray_d, i);
            if (!picture.lights.has_sky() && !state.is_straight) continue;
            const float density =
                state.pdf > 0 ? picture.lights.density_of_sky(normalize_or(direction, {0, 1, 0})) : 0.0f;
            const float share = share_by_chance(picture, state, density);
            add_light(weight * vec3{s.red[i], s.green[i], s.blue[i]} * share, depth <= 1, trace.settings, to);
            if (depth == 0) to.alpha = 1;
        } else if (has_met_none) {
            const vec4 own = empty_pixel(trace.settings);
            to.alpha = own.w;
            add_light(own.xyz() * own.w, true, trace.settings, to);
        } else if (state.is_straight) {
            add_light(weight * plain, depth <= 1, trace.settings, to);
        }
    }
}

/// The chosen emitters that the surfaces of this wave see.
void ask_emitters(const PathPicture& picture, int depth, const Context& context, PathScratch& s) {
    if (s.emitter_rays.empty()) return;
    std::erase_if(s.emitter_rays, [&](EmitterRay& ray) { return !reaches_emitter(picture, context, ray, s); });
    const auto is_far = [](const EmitterRay& r) { return r.is_far; };
    const auto near = std::ranges::stable_partition(s.emitter_rays, is_far);
    const auto count = std::size_t(near.begin() - s.emitter_rays.begin());
    if (count > 0) {
        std::swap(s.wave, s.primary);
        s.wave.count = count, s.wave.stride = std::max(count, plane_stride) + batch_padding;
        s.wave.planes.assign(std::size_t(ray_planes) * s.wave.stride, 0.0f);
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < 3; ++c)
                s.wave.plane(ray_d + std::int32_t(c))[i] = s.emitter_rays[i].direction[c];
        find_sky_colors(picture.trace, false, s);
        std::swap(s.wave, s.primary);
        for (std::size_t i = 0; i < count; ++i) {
            const EmitterRay& ray = s.emitter_rays[i];
            add_light(ray.weight * vec3{s.red[i], s.green[i], s.blue[i]}, depth == 0, picture.trace.settings,
                      s.brought[ray.pixel]);
        }
    }
    for (std::size_t i = count; i < s.emitter_rays.size(); ++i) {
        const EmitterRay& ray = s.emitter_rays[i];
        add_light(ray.weight * picture.trace.emission_at(ray.draw, ray.triangle, ray.origin, ray.direction), depth == 0,
                  picture.trace.settings, s.brought[ray.pixel]);
    }
    s.emitter_rays.clear();
}

/// What surfaces send on becomes the wave.
void take_next(const PathPicture& picture, PathScratch& s) {
    set_wave(s.next, s.wave);
    begin_rays(picture.trace, 0, s);
    s.states.swap(s.next_states);
}

void follow_sample(const PathPicture& picture, const Window& area, std::uint32_t sample, const Context& context,
                   PathScratch& s) {
    make_path_rays(picture.trace, area, sample, s);
    const std::size_t count = s.wave.count;
    s.counts.rays.primary += count;
    begin_rays(picture.trace, float(picture.trace.view.z_near), s);
    s.states.assign(count, PathState{});
    s.brought.assign(count, PathSample{});
    for (int depth = 0; s.wave.count > 0 && !context.cancelled(); ++depth) {
        if (depth > 0) s.counts.rays.deepest = std::max(s.counts.rays.deepest, depth);
        s.next.clear(), s.next_states.clear();
        walk_wave(picture, depth, sample, context, s);
        lay_behind(picture, depth, s);
        ask_emitters(picture, depth, context, s);
        take_next(picture, s);
    }
}

bool is_sound(const PathSample& p) { return is_finite(p.color) && is_finite(p.direct) && is_finite(p.albedo); }

}  // namespace

void follow_paths(const PathPicture& picture, const Window& area, int first, int last, const Context& context,
                  PathScratch& s, PathFilm& film) {
    s.filled_for = 0;  // the planes are recomputed
    s.numbers.clear();
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x)
            s.numbers.emplace_back(x, y, picture.trace.settings.paths.seed);
    for (int sample = first; sample < last && !context.cancelled(); ++sample) {
        follow_sample(picture, area, std::uint32_t(sample), context, s);
        if (context.cancelled()) return;
        for (std::size_t i = 0; i < s.numbers.size(); ++i) {
            PathSample& brought = s.brought[i];
            if (!is_sound(brought)) brought = {.alpha = 1}, ++s.counts.not_finite;
            film.add(area.x + int(i) % area.width, area.y + int(i) / area.width, brought);
        }
    }
}

}  // namespace rakelight::raytrace
