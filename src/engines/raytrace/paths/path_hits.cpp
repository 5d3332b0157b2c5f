// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/paths/path_hits.h"

#include <algorithm>
#include <limits>

#include "math/linear.h"

namespace rakelight::raytrace {
namespace {

constexpr int first_roulette = 3;  ///< surfaces before paths may end by chance

/// Numbers of the i-th hit in the planes that the kernel wrote.
struct StepView {
    const float* planes;
    std::size_t stride, hit;
    float number(std::int32_t plane) const { return planes[std::size_t(plane) * stride + hit]; }
    vec3 vector(std::int32_t plane) const { return {number(plane), number(plane + 1), number(plane + 2)}; }
};

/// Random numbers and a chosen emitter for each hit.
void set_inputs(const PathPicture& picture, std::uint32_t sample, std::size_t count, std::size_t stride,
                PathScratch& s) {
    s.path_in.resize(std::size_t(path_in_planes) * stride);
    s.chosen.resize(count);
    const auto put = [&](std::int32_t plane, std::size_t hit, float value) {
        s.path_in[std::size_t(plane) * stride + hit] = value;
    };
    for (std::size_t i = 0; i < stride; ++i) {
        const std::size_t ray = std::size_t(s.hit_ray[std::min(i, count - 1)]);
        const PathNumbers& numbers = s.numbers[s.wave.pixel_of(ray)];
        const std::uint32_t met = s.states[ray].met;
        if (i >= count) {  // lanes of nothing
            for (std::int32_t plane = 0; plane < path_in_planes; ++plane)
                put(plane, i, plane >= in_lights ? -1.0f : 0.0f);
            continue;
        }
        const auto lobes = numbers.of(sample, group_of(met, group_lobes));
        for (std::size_t k = 0; k < 3; ++k) put(in_choice + std::int32_t(k), i, unit_float(lobes[k]));
        ChosenEmitter& e = s.chosen[i];
        e = picture.lights.is_there() ? picture.lights.choose(numbers.of(sample, group_of(met, group_emitter)))
                                      : ChosenEmitter{};
        for (std::size_t c = 0; c < 3; ++c) {
            put(in_emitter + std::int32_t(c), i, e.place[c]);
            put(in_emitter_n + std::int32_t(c), i, e.normal[c]);
        }
        put(in_emitter_pdf, i, e.density), put(in_emitter_is_far, i, e.is_far);
        put(in_emitter_both, i, e.shines_back), put(in_emitter_size, i, e.size);
        if (!picture.lights.picks_lights()) continue;
        const auto picks = numbers.of(sample, group_of(met, group_lights));
        for (std::size_t k = 0; k < most_picked_lights; ++k)
            put(in_lights + std::int32_t(k), i, float(picture.lights.pick_light(picks[k])));
    }
}

/// Of each hit the color that a dispersing body refracts; paths that are still of all colors draw one.
void set_colors(const PathPicture& picture, std::uint32_t draw, std::uint32_t sample, std::size_t count,
                PathScratch& s) {
    s.hit_color.clear();
    if (!picture.has_dispersion) return;
    const bool parts = picture.trace.list.view(draw).dispersion > 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto ray = std::size_t(s.hit_ray[i]);
        std::int8_t color = s.states[ray].color;
        if (color < 0 && parts) {
            const auto number =
                s.numbers[s.wave.pixel_of(ray)].of(sample, group_of(s.states[ray].met, group_lights))[3];
            color = std::int8_t(std::uint64_t(number) * 3 >> 32);
        }
        s.hit_color.push_back(color);
    }
}

/// The ray to the chosen emitter of a hit.
void ask(const StepView& hit, std::size_t ray, vec3 weight, PathScratch& s) {
    const vec3 own = weight * hit.vector(out_emitter_weight);
    if (!(std::max({own.x, own.y, own.z}) > 0)) return;
    const ChosenEmitter& e = s.chosen[hit.hit];
    EmitterRay out{hit.vector(out_emitter_o),
                   hit.vector(out_emitter_d),
                   own,
                   s.wave.pixel_of(ray),
                   e.draw,
                   e.triangle,
                   e.is_far,
                   {}};
    if (!s.wave.is_primary()) out.media = s.wave.media[ray];
    s.emitter_rays.push_back(out);
}

/// Where the path continues. @param chance  [0, 1) random
void go_on(const PathPicture& picture, const StepView& hit, int depth, std::size_t ray, vec3 weight, float chance,
           PathScratch& s) {
    vec3 own = weight * hit.vector(out_weight);
    const float pdf = hit.number(out_pdf);
    // Behind the last surface what shines is still met by chance, as the weights of those that were asked expect.
    if (depth == picture.trace.max_depth && (!(pdf > 0) || !picture.shines)) return;
    const bool is_through = hit.number(out_through) > 0;
    const std::int8_t before = s.states[ray].color,
                      color = is_through && !s.hit_color.empty() ? s.hit_color[hit.hit] : before;
    if (color >= 0 && before < 0) {
        vec3 one{};
        one[std::size_t(color)] = 3;
        own = own * one;
    }
    const float greatest = std::max({own.x, own.y, own.z});
    if (!(greatest > 0) || !is_finite(own)) return;
    if (depth >= first_roulette && greatest < 1) {  // Arvo & Kirk 1990, "Particle Transport and Image Synthesis"
        const float survives = std::max(greatest, 0.05f);
        if (chance >= survives) return;
        own = own * (1 / survives);
    }
    NextRay next{};
    const vec3 origin = hit.vector(out_o), direction = hit.vector(out_d);
    for (std::size_t c = 0; c < 3; ++c)
        next.numbers[std::size_t(ray_o) + c] = origin[c], next.numbers[std::size_t(ray_d) + c] = direction[c];
    next.pixel = s.wave.pixel_of(ray), next.weight = own;
    if (!s.wave.is_primary()) next.media = s.wave.media[ray];
    if (!s.marks.empty()) next.marks_from = s.marks[ray].on_surface;
    const std::uint32_t draw = s.meetings[ray].draw;
    if (is_through && picture.trace.list.view(draw).is_body != 0) {
        if (hit.number(out_side) > 0)
            next.media.enter(picture.trace.list.draws[draw].material);
        else
            next.media.leave(picture.trace.list.draws[draw].material);
    }
    if (!is_sound(next)) return;
    (is_through ? s.counts.rays.refracted : s.counts.rays.reflected) += 1;
    s.next.push_back(next);
    s.next_states.push_back({.pdf = pdf,
                             .met = s.states[ray].met + 1,
                             .is_straight = s.states[ray].is_straight && hit.number(out_mirrored) > 0,
                             .color = color});
}

/// The data of the first surface.
void take_guides(const StepView& hit, std::size_t ray, PathScratch& s) {
    PathSample& to = s.brought[s.wave.pixel_of(ray)];
    to.alpha = 1;
    to.albedo = hit.vector(out_own) == vec3{} ? hit.vector(out_albedo) : vec3{1, 1, 1};
    to.normal = hit.vector(out_normal);
    to.position = s.wave.vector(ray_o, ray) + s.wave.vector(ray_d, ray) * s.meetings[ray].t;
}

/// What one path gets of the surface that it has met. @return whether the ray goes straight on
bool take_hit(const PathPicture& picture, const StepView& hit, int depth, std::size_t ray, float chance,
              PathScratch& s) {
    const TracePicture& trace = picture.trace;
    PathState& state = s.states[ray];
    const vec3 weight = weight_of(trace, s, ray) * state.through;
    PathSample& to = s.brought[s.wave.pixel_of(ray)];
    const vec3 own = hit.vector(out_own);
    if (own != vec3{}) {
        const Meeting& m = s.meetings[ray];
        const float density = picture.lights.density_of(m.draw, m.triangle) * hit.number(out_per_area);
        add_light(weight * own * share_by_chance(picture, state, density), depth <= 1, trace.settings, to);
    }
    if (depth <= trace.max_depth) {
        add_light(weight * vec3{s.red[hit.hit], s.green[hit.hit], s.blue[hit.hit]}, depth == 0, trace.settings, to);
        if (depth == 0 && to.alpha == 0) take_guides(hit, ray, s);
        ask(hit, ray, weight, s);
    }
    if (hit.number(out_straight) > 0) {
        state.through = state.through * hit.vector(out_weight);
        return std::max({state.through.x, state.through.y, state.through.z}) > 0;
    }
    if (depth <= trace.max_depth) go_on(picture, hit, depth, ray, weight, chance, s);
    return false;
}

void go_on_straight(std::size_t ray, PathScratch& s) {
    ++s.states[ray].met;
    s.live.push_back(std::int32_t(ray));
}

/// From what the kernel has found of the hits of a draw.
void take_hits(const PathPicture& picture, int depth, std::uint32_t draw, std::uint32_t sample, std::size_t count,
               std::size_t room, PathScratch& s) {
    const TracePicture& trace = picture.trace;
    const bool is_blended = trace.is_blended(draw) && !trace.is_opened_by_alpha(draw);
    for (std::size_t i = 0; i < count; ++i) {
        const auto ray = std::size_t(s.hit_ray[i]);
        const auto numbers = s.numbers[s.wave.pixel_of(ray)].of(sample, group_of(s.states[ray].met, group_emitter));
        const float chance = unit_float(numbers[3]), alpha = is_blended ? s.alpha[i] : 1.0f;
        const bool is_there = chance < alpha;
        const StepView hit{s.path_out.data(), room, i};
        s.from[ray] = s.meetings[ray].t * step_behind;
        if (!is_there || take_hit(picture, hit, depth, ray, chance / std::min(alpha, 1.0f), s)) go_on_straight(ray, s);
    }
}

/// Lines and points give their color as surfaces that are not lit do.
void take_marks(const PathPicture& picture, int depth, std::uint32_t sample, std::size_t begin, std::size_t end,
                PathScratch& s) {
    s.counts.marked += end - begin;
    for (std::size_t i = begin; i < end; ++i) {
        const auto ray = std::size_t(s.order[i]);
        const vec4 color = picture.trace.mark_color(s.meetings[ray]);
        const auto numbers = s.numbers[s.wave.pixel_of(ray)].of(sample, group_of(s.states[ray].met, group_emitter));
        if (unit_float(numbers[3]) >= color.w) {
            go_on_straight(ray, s);
            continue;
        }
        PathSample& to = s.brought[s.wave.pixel_of(ray)];
        add_light(weight_of(picture.trace, s, ray) * s.states[ray].through * color.xyz(), depth <= 1,
                  picture.trace.settings, to);
        if (depth > 0 || to.alpha > 0) continue;
        to.alpha = 1, to.albedo = {1, 1, 1};
        to.position = s.wave.vector(ray_o, ray) + s.wave.vector(ray_d, ray) * s.meetings[ray].t;
    }
}

/// The hits of one draw.
void walk_run(const PathPicture& picture, int depth, std::uint32_t sample, const Context& context, std::size_t begin,
              std::size_t end, PathScratch& s) {
    const TracePicture& trace = picture.trace;
    const std::uint32_t draw = s.meetings[std::size_t(s.order[begin])].draw;
    const std::size_t count = end - begin, room = count + batch_padding;
    PathJob job{};
    job.hits = trace.hit_job(draw, !s.wave.is_primary(), false);
    set_hits(begin, end, s, job.hits);
    for (auto* const numbers : {&s.red, &s.green, &s.blue, &s.alpha})
        if (numbers->size() < room) numbers->resize(room);
    job.hits.red = s.red.data(), job.hits.green = s.green.data(), job.hits.blue = s.blue.data();
    job.hits.alpha = s.alpha.data();
    const TileTracer tracer = tracer_of(trace, context, s);
    job.hits.tracer = &tracer;
    set_colors(picture, draw, sample, count, s);
    set_etas(trace, draw, count, s);
    set_inputs(picture, sample, count, room, s);
    s.path_out.resize(std::size_t(path_out_planes) * room);
    job.in = s.path_in.data(), job.out = s.path_out.data(), job.stride = std::int32_t(room);
    job.eta_front = s.eta_front.data(), job.eta_back = s.eta_back.data();
    job.picked_lights = picture.lights.picks_lights() ? most_picked_lights : -1;
    job.light_scale = picture.lights.light_scale();
    job.hits.is_opened = trace.is_opened_by_alpha(draw);
    job.asks_alone = trace.settings.paths.light_sampling == LightSampling::lights;
    job.shines_behind = picture.shines_behind[draw];
    s.counts.not_finite += std::uint64_t(trace.kernels.walk(&job));
    s.counts.shaded += count;
    take_hits(picture, depth, draw, sample, count, room, s);
}

}  // namespace

void walk_wave(const PathPicture& picture, int depth, std::uint32_t sample, const Context& context, PathScratch& s) {
    meet_wave(picture.trace, context, s, [&](std::size_t begin, std::size_t end) {
        if (picture.trace.is_mark(s.meetings[std::size_t(s.order[begin])].draw))
            take_marks(picture, depth, sample, begin, end, s);
        else
            walk_run(picture, depth, sample, context, begin, end, s);
    });
}

bool reaches_emitter(const PathPicture& picture, const Context& context, EmitterRay& ray, PathScratch& s) {
    if (context.cancelled()) return false;
    ++s.counts.rays.shadow;
    const float to = ray.is_far ? std::numeric_limits<float>::infinity() : 1.0f;
    const vec3 seen = picture.trace.light_reaching(ray.origin, ray.direction, to, ray.media);
    ray.weight = ray.weight * seen;
    return ray.weight != vec3{} && is_finite(ray.weight);
}

}  // namespace rakelight::raytrace
