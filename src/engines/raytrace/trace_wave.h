// SPDX-License-Identifier: Apache-2.0
// Rays that are followed together: those through the pixels of a tile, or those that surfaces met before send on.
#pragma once
#include <vector>

#include "engines/raytrace/media.h"
#include "engines/raytrace/trace_picture.h"

namespace rakelight::raytrace {

/// Rays; of primary ones, ray i through pixel i, the last three arrays are empty.
struct RayWave {
    std::vector<float> planes;  ///< [ray_planes][stride]
    std::size_t stride = 0, count = 0;
    std::vector<std::uint32_t> pixel;  ///< [count]
    std::vector<vec3> weight;          ///< [count] of what they bring
    std::vector<Media> media;          ///< [count] that they are in
    std::vector<float> marks_from;     ///< [count] from where on they meet lines and points

    bool is_primary() const { return pixel.empty(); }
    RayView view() const { return {planes.data(), std::int32_t(stride)}; }
    float* plane(std::int32_t number) { return planes.data() + std::size_t(number) * stride; }
    vec3 vector(std::int32_t number, std::size_t ray) const {
        const float* const p = planes.data() + std::size_t(number) * stride + ray;
        return {p[0], p[stride], p[2 * stride]};
    }
    std::uint32_t pixel_of(std::size_t ray) const { return is_primary() ? std::uint32_t(ray) : pixel[ray]; }
};

/// A ray that a surface sends on.
struct NextRay {
    float numbers[ray_planes];
    std::uint32_t pixel;
    vec3 weight;
    Media media;
    float marks_from = 0;  ///< [m] up to here marks lie on the surface that it leaves, and were met before
};

/// How far a ray has come among lines and points. They and surfaces are met independently of each other, so that the surface is
/// still there behind a mark that lies on it.
struct MarkProgress {
    MarkLimit from;                ///< marks begin behind the last surface and what lies on it
    MarkPlace last;                ///< the last mark behind it
    std::uint32_t run = no_index;  ///< MarkedDraw::run of the last mark
    float on_surface = 0;          ///< [m] behind the last surface: what is nearer lies on it
};

/// Counts of a tile.
struct RayCounts {
    std::uint64_t shaded = 0, marked = 0, not_finite = 0;
    RayStats rays;
};

/// What following rays needs, and gives.
struct WaveScratch {
    RayWave wave;
    /// Planes of rays through the pixels' centers, where a pixel has more samples than one: what is shaded once per triangle and pixel,
    /// as by rasterizers, is shaded there.
    std::vector<float> centers;
    std::vector<Meeting> meetings;    ///< [rays]
    std::vector<float> from;          ///< [rays] where they begin, for surfaces
    std::vector<MarkProgress> marks;  ///< [rays] the same for marks; empty: the picture has none
    std::vector<float> rest;          ///< [rays] what is not covered yet
    std::vector<std::int32_t> live,
        going;  ///< rays that continue behind something blended; those that are followed now
    std::vector<std::int32_t> order, hit_ray, hit_triangle;  ///< hits by draw; those of one draw
    std::vector<float> hit_t, eta_front, eta_back;
    std::vector<std::int8_t> hit_color;  ///< [hits] of light of one color, 0 to 2; < 0, or empty: of all
    std::vector<float> red, green, blue, alpha, next_planes_of_hits;
    std::vector<vec3> sum;      ///< [pixels] what all rays have brought
    std::vector<NextRay> next;  ///< that surfaces of this wave send on
    RayCounts counts;
};

/// All rays of s.wave begin there.
void begin_rays(const TracePicture& picture, float from, WaveScratch& s);

/// Follows the rays of s.wave from where they begin until they hit something opaque, or nothing. Their light goes into s.sum,
/// continuing rays into s.next. @param depth of reflections and refractions before
void follow(const TracePicture& picture, const Context& context, int depth, WaveScratch& s);

/// The environment's picture in the directions of s.wave's rays, into red, green and blue.
void find_sky_colors(const TracePicture& picture, bool is_parallel, WaveScratch& s);

/// The nearest surface that a ray of the wave shows. @param with_blended  false: only opaque ones
Meeting find_surface(const TracePicture& picture, const WaveScratch& s, std::size_t ray, bool with_blended);
/// The same of those at `from` < t, up to `to`.
Meeting find_surface(const TracePicture& picture, const WaveScratch& s, std::size_t ray, bool with_blended, float from,
                     float to);
/// The nearest surface, line or point (TracePicture::is_mark()); lines and points lie over surfaces at the same depth. The
/// ray continues behind marks by itself.
Meeting find_first(const TracePicture& picture, WaveScratch& s, std::size_t ray, bool with_blended);

/// For the jobs of the hits that set_hits() set.
TileTracer tracer_of(const TracePicture& picture, const Context& context, WaveScratch& s);

/// Whether a ray can be followed: all of it is finite.
bool is_sound(const NextRay& ray);

/// @param rays  become the wave's
void set_wave(const std::vector<NextRay>& rays, RayWave& wave);

/// Indices of refraction before the surface over those behind it, by what the rays are in, of the hits that set_hits() set.
void set_etas(const TracePicture& picture, std::uint32_t draw, std::size_t count, WaveScratch& s);

/// What reaches the pixel of a ray's light: its weight, and what the body that it is in has absorbed on the way.
vec3 weight_of(const TracePicture& picture, const WaveScratch& s, std::size_t ray);

/// The hits of one draw: rays `begin` to `end` of s.order, into the job.
void set_hits(std::size_t begin, std::size_t end, WaveScratch& s, HitJob& job);

/// Calls run(begin, end) for the hits of each draw in s.order, which gets sorted.
template <class Run>
void for_each_run(WaveScratch& s, const Run& run) {
    const auto draw_of = [&](std::int32_t ray) { return s.meetings[std::size_t(ray)].draw; };
    if (!std::ranges::is_sorted(s.order, {}, draw_of)) std::ranges::stable_sort(s.order, {}, draw_of);
    for (std::size_t begin = 0; begin < s.order.size();) {
        std::size_t end = begin + 1;
        while (end < s.order.size() && draw_of(s.order[end]) == draw_of(s.order[begin])) ++end;
        run(begin, end);
        begin = end;
    }
}

/// Finds the hits of the rays of s.wave from where they begin and calls run(begin, end) for the hits of each draw, until no
/// ray is in s.live. `run` puts rays there that continue behind their hit.
template <class Run>
void meet_wave(const TracePicture& picture, const Context& context, WaveScratch& s, const Run& run) {
    const std::size_t count = s.wave.count;
    s.live.resize(count);
    for (std::size_t i = 0; i < count; ++i) s.live[i] = std::int32_t(i);
    s.meetings.assign(count, Meeting{});
    while (!s.live.empty() && !context.cancelled()) {
        s.order.clear();
        s.live.swap(s.going);
        s.live.clear();
        for (const std::int32_t ray : s.going) {
            if (context.cancelled()) return;
            s.meetings[std::size_t(ray)] = find_first(picture, s, std::size_t(ray), true);
            if (s.meetings[std::size_t(ray)].draw != no_index) s.order.push_back(ray);
        }
        for_each_run(s, run);
    }
}

}  // namespace rakelight::raytrace
