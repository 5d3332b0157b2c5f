// SPDX-License-Identifier: Apache-2.0
// What the maps of a material are read for, for the recorder: coordinates, probes, levels, texels with their weights.
#pragma once
#include "engines/raster/inspect/kernels/trace_kernel.h"
#include "engines/raster/kernels/whole_pixels.h"

namespace rakelight::raster::RL_ISA {

using cpu::Footprint, cpu::Taps, cpu::fraction_bits, cpu::footprint_of, cpu::level_of_detail, cpu::probes_of,
    cpu::sample;
using cpu::transformed, cpu::height_levels, cpu::slope_probes;
using cpu_shading::wrap_repeat, cpu_shading::mip_none, cpu_shading::mip_nearest;

inline void put(float (&to)[3], vec3 v) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }
inline void put(float (&to)[4], vec4 v) { to[0] = v.x, to[1] = v.y, to[2] = v.z, to[3] = v.w; }

/// A texel of the border is one of the opposite edge, or of the same.
inline int32_t wrapped(int32_t i, int32_t size, int32_t mode) {
    return mode == wrap_repeat ? (i + size) % size : clamp(i, 0, size - 1);
}

inline void put_texel(const TextureView& t, int32_t texel, int32_t probe, float weight, TracedTexels& out) {
    if (!(weight > 0.0f) || out.count == most_texels) return;
    TracedTexel& to = out.texel[out.count];
    to.probe = probe;
    to.level = 0;
    const auto begin = [&t](int32_t level) { return t.origin[level] - t.width[level] - 3; };  // of its border
    while (to.level + 1 < t.levels && texel >= begin(to.level + 1)) ++to.level;
    const int32_t place = texel - begin(to.level), stride = t.width[to.level] + 2;
    to.x = wrapped(place % stride - 1, t.width[to.level], t.wrap_u);
    to.y = wrapped(place / stride - 1, t.height[to.level], t.wrap_v);
    for (int32_t i = 0; i < out.count; ++i) {
        TracedTexel& known = out.texel[i];
        if (known.probe != probe || known.level != to.level || known.x != to.x || known.y != to.y) continue;
        known.weight += weight;
        return;
    }
    ++out.count;
    to.weight = weight;
    Footprint alone{};
    alone.taps[0].texel = texel;
    put(to.value, sample(t, alone));
}

inline float weight_of(int32_t fixed) { return float(fixed & 0xffff) / float(1 << fraction_bits); }

inline void trace_taps(const TextureView& t, const Taps& taps, bool linear, int32_t probe, float weight,
                       TracedTexels& out) {
    if (!linear) return put_texel(t, taps.texel, probe, weight, out);
    const float right = weight_of(taps.along_x), lower = weight_of(taps.along_y);
    for (int32_t k = 0; k < 4; ++k)
        put_texel(t, taps.texel + k % 2 + k / 2 * taps.stride, probe,
                  weight * (k % 2 == 0 ? 1.0f - right : right) * (k / 2 == 0 ? 1.0f - lower : lower), out);
}

/// The texels of a footprint.
inline void trace_texels(const TextureView& t, const Footprint& f, int32_t probe, float weight, TracedTexels& out) {
    const float second = f.has_two_levels ? weight_of(f.between) : 0.0f;
    trace_taps(t, f.taps[0], f.linear, probe, weight * (1.0f - second), out);
    if (f.has_two_levels) trace_taps(t, f.taps[1], f.linear, probe, weight * second, out);
}

/// How texel() reads: the probes and their level of detail; one in the middle where none are wanted.
inline lit::Probes trace_probes(const TextureView& t, const TexCoords& c, int32_t most, TracedTexture& out) {
    lit::Probes p{};
    if (most > 1 && t.mip != mip_none && t.levels > 1) p = probes_of(t, c, most);
    out.probes = 1;
    out.axis_u = out.axis_v = 0;
    out.level_of_detail = p.is_stretched ? p.lod : level_of_detail(t, c);
    if (!p.is_stretched) return p;
    out.probes = to_int(p.count);
    out.axis_u = p.axis.x, out.axis_v = p.axis.y;
    return p;
}

/// What texel() reads where: its coordinates, probes and levels.
inline void trace_texture(const cpu::Job<cpu::EveryMaterial>& job, int role, const ShadingPoint& p, TracedTexture& out,
                          TracedTexels* texels) {
    const TextureSlot& slot = job.material().map[role];
    if (slot.view == nullptr) return;
    const TextureView& t = *slot.view;
    TexCoords room;
    const TexCoords& c = transformed(slot, cpu::texcoords_of(slot, p), room);
    out.is_used = 1;
    out.u = c.uv.x;
    out.v = c.uv.y;
    const lit::Probes probes = trace_probes(t, c, p.anisotropy, out);
    out.level = 0;
    if (t.mip != mip_none && t.levels > 1 && out.level_of_detail > 0.0f) {
        out.level = clamp(out.level_of_detail, 0.0f, float(t.levels - 1));
        if (t.mip == mip_nearest) out.level = float(to_int(out.level + 0.5f));
    }
    put(out.value, cpu::texel(job, role, p));
    if (texels == nullptr) return;
    const bool linear = (out.probes > 1 || out.level_of_detail > 0.0f ? t.minify_linear : t.magnify_linear) != 0;
    for (int32_t i = 0; i < out.probes; ++i) {
        TexCoords moved = c;
        if (out.probes > 1) moved.uv = lit::probe_place(probes, c.uv, i);
        trace_texels(t, footprint_of(t, moved, out.level_of_detail, linear), i, 1.0f / float(out.probes), *texels);
    }
}

/// The mip level that sample() reads at a level of detail.
inline float level_read(const TextureView& t, float lod) {
    if (t.mip == mip_none || t.levels == 1) return 0.0f;
    const float level = clamp(lod, 0.0f, float(t.levels - 1));
    return t.mip == mip_nearest ? float(to_int(level + 0.5f)) : level;
}

/// How the height map is read where the ray arrives: four heights a probe where the normal is that of its slopes.
inline void trace_heights(const WholePixels& p, TracedTexture& out, TracedTexels* texels) {
    const auto& job = p.material;
    const cpu::HeightPlace& place = p.state().bumps.place;
    const vec2 uv = p.state().bumps.point.uv;
    const TextureSlot& slot = job.material().map[role_height];
    const TextureView& t = *slot.view;
    const bool is_slope = cpu::uses_slopes(job);
    TexCoords room;
    TexCoords at = transformed(slot, p.point().texcoords[slot.texcoord_set == 0 ? 0 : 1], room);
    lit::Probes probes{};
    probes.count = probes.inverse = 1.0f, probes.lod = place.lod;
    if (is_slope && job.of.anisotropy > 1) probes = slope_probes(place, at, job.of.anisotropy);
    const lit::HeightLevels levels = height_levels(t);
    const real level = is_slope ? lit::slope_level(levels, probes.lod) : probes.lod;
    const real half = is_slope ? 0.5f * lit::slope_width(levels, level) : 0.0f;
    const vec2 ways[4] = {vec2(half / float(t.width[0]), 0.0f), vec2(-half / float(t.width[0]), 0.0f),
                          vec2(0.0f, half / float(t.height[0])), vec2(0.0f, -half / float(t.height[0]))};
    out.is_used = 1;
    out.u = uv.x, out.v = uv.y;
    out.probes = to_int(probes.count);
    out.axis_u = out.axis_v = 0;
    if (out.probes > 1) out.axis_u = probes.axis.x, out.axis_v = probes.axis.y;
    out.level_of_detail = probes.lod;
    out.level = level_read(t, level);
    const int32_t heights = is_slope ? 4 : 1;
    const real share = 1.0f / float(heights * out.probes);
    vec4 sum(0.0f);
    for (int32_t i = 0; i < out.probes; ++i)
        for (int32_t k = 0; k < heights; ++k) {
            at.uv = (out.probes > 1 ? lit::probe_place(probes, uv, i) : uv) + ways[k];
            const Footprint footprint = footprint_of(t, at, level, true);
            sum = sum + sample(t, footprint) * share;
            if (texels != nullptr) trace_texels(t, footprint, i, share, *texels);
        }
    put(out.value, sum);
}

}  // namespace rakelight::raster::RL_ISA
