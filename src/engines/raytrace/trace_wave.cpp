// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/trace_wave.h"

#include <algorithm>
#include <limits>

#include "math/linear.h"

namespace rakelight::raytrace {
namespace {

constexpr float least_weight = 1e-3f;  ///< of rays that continue: a quarter of a step of an 8-bit picture

/// What a ray shows: sides that are not culled, where masks leave something. Culling is for primary rays.
class SeenFilter final : public RayFilter {
public:
    SeenFilter(const TracePicture& picture, const RayWave& wave, std::size_t ray, bool with_blended)
        : picture_(picture), wave_(wave), ray_(std::int32_t(ray)), with_blended_(with_blended) {}
    bool counts(const Meeting& meeting) const override {
        if (wave_.is_primary() && picture_.is_culled(meeting)) return false;
        if (!with_blended_ && picture_.is_blended(meeting.draw)) return false;
        return !picture_.is_masked(meeting.draw) || !picture_.is_cut_out(meeting, wave_.view(), ray_);
    }

private:
    const TracePicture& picture_;
    const RayWave& wave_;
    std::int32_t ray_;
    bool with_blended_;
};

template <class T>
void pad(std::vector<T>& v, std::size_t count) {
    v.resize(count + batch_padding);
    std::fill(v.begin() + std::ptrdiff_t(count), v.end(), v[count - 1]);
}

/// Numbers of the i-th hit in the planes that the kernel wrote.
struct NextView {
    const float* planes;
    std::size_t stride, hit;
    float number(std::int32_t plane) const { return planes[std::size_t(plane) * stride + hit]; }
    vec3 vector(std::int32_t plane) const { return {number(plane), number(plane + 1), number(plane + 2)}; }
};

void put3(NextRay& ray, std::int32_t plane, vec3 v) {
    for (std::size_t c = 0; c < 3; ++c) ray.numbers[std::size_t(plane) + c] = v[c];
}

/// One ray of a hit. @param share  of the hit's own light in the pixel
void send_on(const TracePicture& picture, const NextView& hit, std::int32_t lobe, std::size_t ray, vec3 share,
             WaveScratch& s) {
    const std::int32_t base = next_lobes + lobe * lobe_planes;
    const vec3 weight = share * hit.vector(base + lobe_weight);
    if (!(std::max({weight.x, weight.y, weight.z}) > least_weight)) return;
    const bool goes_through = lobe == lobe_refracted;
    const vec3 place = hit.vector(next_o), normal = hit.vector(next_n);
    const float offset = hit.number(next_offset);
    NextRay out{};
    put3(out, ray_o, place + normal * (goes_through ? -offset : offset));
    put3(out, ray_d, hit.vector(base + lobe_d));
    put3(out, ray_o_dx, hit.vector(next_o_dx)), put3(out, ray_o_dy, hit.vector(next_o_dy));
    put3(out, ray_d_dx, hit.vector(base + lobe_d_dx)), put3(out, ray_d_dy, hit.vector(base + lobe_d_dy));
    out.pixel = s.wave.pixel_of(ray);
    out.weight = weight;
    if (!s.wave.is_primary()) out.media = s.wave.media[ray];
    if (!s.marks.empty()) out.marks_from = s.marks[ray].on_surface;
    const std::uint32_t draw = s.meetings[ray].draw, body = picture.list.draws[draw].material;
    if (goes_through && picture.list.view(draw).is_body != 0) {
        if (hit.number(next_side) > 0)
            out.media.enter(body);
        else
            out.media.leave(body);
    }
    if (!is_sound(out)) return;
    (goes_through ? s.counts.rays.refracted : s.counts.rays.reflected) += 1;
    s.next.push_back(out);
}

/// Adds what one ray gets of a hit; where that is not opaque the ray continues.
void lay(const TracePicture& picture, std::size_t ray, vec3 color, float alpha, WaveScratch& s) {
    vec3& sum = s.sum[s.wave.pixel_of(ray)];
    sum = sum + weight_of(picture, s, ray) * color * (s.rest[ray] * alpha);
    s.rest[ray] *= 1 - alpha;
    if (s.rest[ray] > 0) s.live.push_back(std::int32_t(ray));
}

/// Lines and points are not lit.
void show_marks(const TracePicture& picture, std::size_t begin, std::size_t end, WaveScratch& s) {
    s.counts.marked += end - begin;
    for (std::size_t i = begin; i < end; ++i) {
        const auto ray = std::size_t(s.order[i]);
        const vec4 color = picture.mark_color(s.meetings[ray]);
        lay(picture, ray, color.xyz(), color.w, s);
    }
}

/// Lights the hits of one draw.
void shade_run(const TracePicture& picture, const Context& context, int depth, std::size_t begin, std::size_t end,
               WaveScratch& s) {
    const std::uint32_t draw = s.meetings[std::size_t(s.order[begin])].draw;
    const std::size_t count = end - begin;
    const bool goes_on = depth < picture.max_depth && picture.goes_on(draw);
    HitJob job = picture.hit_job(draw, !s.wave.is_primary(), goes_on);
    set_hits(begin, end, s, job);
    // Mirrors and shadows are found at each sample.
    const bool is_shaded_once = s.wave.is_primary() && picture.settings.samples > 1 && !picture.settings.shadows &&
                                !goes_on && job.shape.kind == shape_none;
    if (is_shaded_once) job.rays = {s.centers.data(), std::int32_t(s.wave.stride)};
    const std::size_t room = count + batch_padding;
    for (auto* const numbers : {&s.red, &s.green, &s.blue, &s.alpha})
        if (numbers->size() < room) numbers->resize(room);
    job.red = s.red.data(), job.green = s.green.data(), job.blue = s.blue.data(), job.alpha = s.alpha.data();
    const TileTracer tracer = tracer_of(picture, context, s);
    job.tracer = &tracer;
    NextRays next{};
    const bool is_blended = picture.is_blended(draw), is_opened = goes_on && picture.is_opened_by_alpha(draw);
    job.is_opened = is_opened;
    if (goes_on) {
        set_etas(picture, draw, count, s);
        s.next_planes_of_hits.resize(std::size_t(next_planes) * room);
        next = {s.next_planes_of_hits.data(), std::int32_t(room), s.eta_front.data(), s.eta_back.data()};
        job.next = &next;
    }
    s.counts.not_finite += std::uint64_t(picture.kernels.shade(&job));
    s.counts.shaded += count;
    for (std::size_t i = 0; i < count; ++i) {
        const auto ray = std::size_t(s.hit_ray[i]);
        const bool is_sound = s.alpha[i] - s.alpha[i] == 0;
        const float alpha = !is_blended || is_opened ? 1.0f : is_sound ? std::clamp(s.alpha[i], 0.0f, 1.0f) : 0.0f;
        const vec3 weight = weight_of(picture, s, ray);
        if (goes_on)
            for (std::int32_t lobe = 0; lobe < lobe_count; ++lobe)
                send_on(picture, {s.next_planes_of_hits.data(), room, i}, lobe, ray, weight * (s.rest[ray] * alpha), s);
        lay(picture, ray, {s.red[i], s.green[i], s.blue[i]}, alpha, s);
        s.from[ray] = s.meetings[ray].t * step_behind;
    }
}

}  // namespace

bool is_sound(const NextRay& ray) {
    for (const float number : ray.numbers)
        if (!(number - number == 0)) return false;
    return is_finite(ray.weight);
}

void set_wave(const std::vector<NextRay>& rays, RayWave& wave) {
    wave.count = rays.size();
    wave.stride = rays.size() + 48;
    wave.planes.resize(std::size_t(ray_planes) * wave.stride);
    wave.pixel.resize(rays.size()), wave.weight.resize(rays.size()), wave.media.resize(rays.size());
    wave.marks_from.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (std::int32_t p = 0; p < ray_planes; ++p) wave.plane(p)[i] = rays[i].numbers[p];
        wave.pixel[i] = rays[i].pixel, wave.weight[i] = rays[i].weight, wave.media[i] = rays[i].media;
        wave.marks_from[i] = rays[i].marks_from;
    }
}

void set_etas(const TracePicture& picture, std::uint32_t draw, std::size_t count, WaveScratch& s) {
    const std::uint32_t body = picture.list.draws[draw].material;
    const auto index_in = [&](const Media& media, int color) {
        const std::uint32_t around = media.innermost();
        return around == no_index ? 1.0f : refraction_of(picture.list.materials[around].factors, color);
    };
    s.eta_front.resize(count), s.eta_back.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        Media media = s.wave.is_primary() ? Media{} : s.wave.media[std::size_t(s.hit_ray[i])];
        const int color = s.hit_color.empty() ? -1 : s.hit_color[i];
        const float own = refraction_of(picture.list.view(draw), color);
        s.eta_front[i] = index_in(media, color) / own;
        // In another body that overlaps this one the ray stays as it is.
        const float before = media.innermost() == no_index ? own : index_in(media, color);
        media.leave(body);
        s.eta_back[i] = before / index_in(media, color);
    }
    pad(s.eta_front, count), pad(s.eta_back, count);
}

vec3 weight_of(const TracePicture& picture, const WaveScratch& s, std::size_t ray) {
    if (s.wave.is_primary()) return {1, 1, 1};
    const vec3 weight = s.wave.weight[ray];
    const std::uint32_t body = s.wave.media[ray].innermost();
    if (body == no_index) return weight;
    const vec3 d = s.wave.vector(ray_d, ray);
    return weight * absorbed(picture.list.materials[body].factors, s.meetings[ray].t * length(d));
}

void find_sky_colors(const TracePicture& picture, bool is_parallel, WaveScratch& s) {
    const std::size_t room = s.wave.count + batch_padding;
    for (auto* const numbers : {&s.red, &s.green, &s.blue})
        if (numbers->size() < room) numbers->resize(room);
    SkyJob job{std::int32_t(s.wave.count),
               s.wave.view(),
               &picture.list.views.environment_view,
               is_parallel,
               s.red.data(),
               s.green.data(),
               s.blue.data()};
    picture.kernels.sky(&job);
}

TileTracer tracer_of(const TracePicture& picture, const Context& context, WaveScratch& s) {
    return {picture, context, s.counts.rays.shadow, s.hit_ray.data(),
            s.wave.is_primary() ? nullptr : s.wave.media.data()};
}

Meeting find_surface(const TracePicture& picture, const WaveScratch& s, std::size_t ray, bool with_blended, float from,
                     float to) {
    const RayWave& wave = s.wave;
    const SeenFilter filter(picture, wave, ray, with_blended);
    const bool needs_filter =
        (wave.is_primary() ? picture.has_filtered : picture.has_masked) || (!with_blended && picture.has_holes);
    return picture.first(picture.in_rays(wave.vector(ray_o, ray)), wave.vector(ray_d, ray), from, to,
                         needs_filter ? &filter : nullptr);
}

Meeting find_surface(const TracePicture& picture, const WaveScratch& s, std::size_t ray, bool with_blended) {
    const float to = s.wave.is_primary() ? float(picture.view.z_far) : std::numeric_limits<float>::infinity();
    return find_surface(picture, s, ray, with_blended, s.from[ray], to);
}

void set_hits(std::size_t begin, std::size_t end, WaveScratch& s, HitJob& job) {
    const std::size_t count = end - begin;
    s.hit_ray.assign(s.order.begin() + std::ptrdiff_t(begin), s.order.begin() + std::ptrdiff_t(end));
    s.hit_triangle.resize(count), s.hit_t.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Meeting& m = s.meetings[std::size_t(s.hit_ray[i])];
        s.hit_triangle[i] = std::int32_t(m.triangle), s.hit_t[i] = m.t;
    }
    pad(s.hit_ray, count), pad(s.hit_triangle, count), pad(s.hit_t, count);
    job.count = std::int32_t(count);
    job.ray = s.hit_ray.data(), job.triangle = s.hit_triangle.data(), job.t = s.hit_t.data();
    job.rays = s.wave.view();
}

void follow(const TracePicture& picture, const Context& context, int depth, WaveScratch& s) {
    s.rest.assign(s.wave.count, 1.0f);
    s.next.clear();
    meet_wave(picture, context, s, [&](std::size_t begin, std::size_t end) {
        if (picture.is_mark(s.meetings[std::size_t(s.order[begin])].draw))
            show_marks(picture, begin, end, s);
        else
            shade_run(picture, context, depth, begin, end, s);
    });
}

}  // namespace rakelight::raytrace
