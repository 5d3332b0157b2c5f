// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/trace_tile.h"

#include <algorithm>
#include <utility>

#include "engines/empty_pixel.h"

namespace rakelight::raytrace {
namespace {

constexpr std::size_t most_in_wave = 8192;  ///< rays: more are followed in parts, pixel by pixel in the end

/// The same vector for all rays.
void fill(RayWave& wave, std::int32_t number, dvec3 v) {
    for (std::size_t c = 0; c < 3; ++c) std::fill_n(wave.plane(number + std::int32_t(c)), plane_stride, float(v[c]));
}

/// The colors of rays of the wave that hit no surface, into red, green and blue. @return false: `background` is there
bool find_sky(const TracePicture& picture, WaveScratch& s) {
    if (!picture.list.views.environment) return false;
    if (s.wave.is_primary() && !picture.list.scene.environment->is_background) return false;
    find_sky_colors(picture, s.wave.is_primary() && picture.view.orthographic, s);
    return true;
}

/// What is behind everything that primary rays hit.
void lay_background(const TracePicture& picture, TileScratch& s) {
    const vec4 behind = empty_pixel(picture.settings);
    const bool has_sky = find_sky(picture, s);
    s.covered.resize(s.wave.count);
    for (std::size_t i = 0; i < s.wave.count; ++i) {
        const vec4 own = has_sky ? vec4{s.red[i], s.green[i], s.blue[i], 1} : behind;
        const float share = s.rest[i] * own.w;
        s.covered[i] = 1 - s.rest[i] + share;
        s.sum[i] = s.covered[i] > 0 ? s.sum[i] + own.xyz() * share : own.xyz();
    }
}

/// The light of rays that hit nothing: the environment if there is one, else the background.
void lay_surroundings(const TracePicture& picture, TileScratch& s) {
    const vec3 behind = light_of_background(picture.settings) * picture.settings.background.w;
    const bool has_sky = find_sky(picture, s);
    for (std::size_t i = 0; i < s.wave.count; ++i) {
        const vec3 own = has_sky ? vec3{s.red[i], s.green[i], s.blue[i]} : behind;
        vec3& sum = s.sum[s.wave.pixel[i]];
        sum = sum + s.wave.weight[i] * own * s.rest[i];
    }
}

/// What is to be followed: all rays of a pixel stay together, in their order, so that no pixel depends on its neighbors.
void put_off(int depth, std::vector<NextRay> rays, TileScratch& s) {
    if (rays.empty()) return;
    if (rays.size() > most_in_wave) {
        const auto [least, most] = std::ranges::minmax(rays, {}, &NextRay::pixel);
        const std::uint32_t low = least.pixel, middle = low + (most.pixel - low) / 2;
        if (low < most.pixel) {
            std::vector<NextRay> rest;
            std::ranges::copy_if(rays, std::back_inserter(rest), [&](const NextRay& r) { return r.pixel > middle; });
            std::erase_if(rays, [&](const NextRay& r) { return r.pixel > middle; });
            put_off(depth, std::move(rest), s);
            return put_off(depth, std::move(rays), s);
        }
        s.counts.rays.dropped += rays.size() - most_in_wave;
        rays.resize(most_in_wave);
    }
    s.waiting.push_back({depth, std::move(rays)});
}

/// What surfaces send on, and what comes of it.
void follow_on(const TracePicture& picture, const Context& context, TileScratch& s) {
    put_off(1, std::exchange(s.next, {}), s);
    while (!s.waiting.empty()) {
        const TileScratch::Waiting now = std::move(s.waiting.back());
        s.waiting.pop_back();
        if (context.cancelled()) continue;
        s.counts.rays.deepest = std::max(s.counts.rays.deepest, now.depth);
        set_wave(now.rays, s.wave);
        begin_rays(picture, 0, s);
        follow(picture, context, now.depth, s);
        lay_surroundings(picture, s);
        put_off(now.depth + 1, std::exchange(s.next, {}), s);
    }
}

void trace_sample(const TracePicture& picture, const Window& area, shading::SamplePosition at, const Context& context,
                  std::vector<vec4>& to, TileScratch& s) {
    make_primary(picture, area, at, s);
    const std::size_t count = s.wave.count;
    s.counts.rays.primary += count;
    begin_rays(picture, float(picture.view.z_near), s);
    s.sum.assign(count, vec3{});
    follow(picture, context, 0, s);
    lay_background(picture, s);
    std::swap(s.wave, s.primary);
    follow_on(picture, context, s);
    for (std::size_t i = 0; i < count; ++i) {
        const float alpha = s.covered[i];
        const vec3 color = alpha > 0 ? s.sum[i] * (1 / alpha) : s.sum[i];
        to[i] = {color.x, color.y, color.z, alpha};
    }
}

}  // namespace

void make_primary(const TracePicture& picture, const Window& area, shading::SamplePosition at, TileScratch& s) {
    const shading::PictureCamera& view = picture.view;
    const shading::PixelRays rays = shading::pixel_rays(view, area.x, area.y);
    std::swap(s.wave, s.primary);
    RayWave& wave = s.wave;
    wave.count = std::size_t(area.width) * std::size_t(area.height);
    wave.pixel.clear(), wave.weight.clear(), wave.media.clear();
    if (std::exchange(s.filled_for, picture.number) != picture.number) {
        wave.stride = plane_stride;
        wave.planes.resize(std::size_t(ray_planes) * plane_stride);
        const dvec3 none{}, ahead = -view.camera_to_world[2].xyz();
        fill(wave, view.orthographic ? ray_d : ray_o, view.orthographic ? ahead : none);
        fill(wave, ray_o_dx, view.orthographic ? rays.along_x : none);
        fill(wave, ray_o_dy, view.orthographic ? rays.along_y : none);
        fill(wave, ray_d_dx, view.orthographic ? none : rays.along_x);
        fill(wave, ray_d_dy, view.orthographic ? none : rays.along_y);
    }
    for (std::size_t c = 0; c < 3; ++c) {
        float* to = wave.plane((view.orthographic ? ray_o : ray_d) + std::int32_t(c));
        for (int y = 0; y < area.height; ++y) {
            const double row = rays.along_y[c] * (y + at.y / 16.0) + rays.first[c] + rays.along_x[c] * (at.x / 16.0);
            for (int x = 0; x < area.width; ++x) *to++ = float(row + rays.along_x[c] * x);
        }
    }
}

void trace_tile(const TracePicture& picture, const Window& area, const Context& context, TileScratch& s) {
    const std::size_t count = std::size_t(area.width) * std::size_t(area.height);
    s.color.assign(count, empty_pixel(picture.settings));
    const auto positions = shading::sample_positions(picture.settings.samples);
    if (!picture.settings.colors) {
        // data alone
    } else if (positions.size() == 1) {
        trace_sample(picture, area, positions[0], context, s.color, s);
    } else {
        make_primary(picture, area, {0, 0}, s);
        s.centers = s.wave.planes;
        std::swap(s.wave, s.primary);
        s.sample_colors.assign(count * positions.size(), vec4{});
        for (std::size_t k = 0; k < positions.size(); ++k) {
            trace_sample(picture, area, positions[k], context, s.color, s);
            for (std::size_t i = 0; i < count; ++i) s.sample_colors[i * positions.size() + k] = s.color[i];
        }
        for (std::size_t i = 0; i < count; ++i)
            s.color[i] = shading::mean_of_samples(s.sample_colors.data() + i * positions.size(), positions.size());
    }
    if (picture.settings.channels != 0) find_data(picture, area, context, s);
}

}  // namespace rakelight::raytrace
