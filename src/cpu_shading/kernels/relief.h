// SPDX-License-Identifier: Apache-2.0
// Height maps: where a ray into the relief meets it, its slopes, and the shadows that heights throw on each other: factors
// and texels given to the lighting text. Per instruction set.
#pragma once
#include "cpu_shading/kernels/maps.h"
#include "cpu_shading/kernels/texels.h"

namespace rakelight::cpu_shading::RL_ISA {

static_assert(shading::relief_none == RL_RELIEF_NONE && shading::relief_height == RL_RELIEF_HEIGHT &&
              shading::relief_parallax == RL_RELIEF_PARALLAX && shading::relief_limited == RL_RELIEF_LIMITED &&
              shading::relief_steep == RL_RELIEF_STEEP && shading::relief_occlusion == RL_RELIEF_OCCLUSION);
static_assert(shading::bump_both == RL_BUMP_BOTH && shading::bump_diffuse == RL_BUMP_DIFFUSE &&
              shading::bump_specular == RL_BUMP_SPECULAR);

/// A job's height map at a vector of points.
struct HeightPlace {
    Maps maps;
    real level;  ///< the height that lies in the polygon
    real lod;
};

/// All that bumps are made of at a vector of points.
struct Bumps {
    lit::Frame frame;
    HeightPlace place;       ///< set where the job has a relief
    lit::ReliefPoint point;  ///< likewise
};

inline lit::Relief relief_of(const shading::ReliefFactors& r) {
    lit::Relief out;
    out.technique = r.technique;
    out.fewest_layers = r.min_steps, out.most_layers = r.max_steps, out.bisections = r.refinement_steps;
    out.depth = real(r.depth);
    out.to_uv_u = vec2(real(r.to_uv[0][0]), real(r.to_uv[0][1]));
    out.to_uv_v = vec2(real(r.to_uv[1][0]), real(r.to_uv[1][1]));
    out.to_map_u = vec2(real(r.to_map[0][0]), real(r.to_map[0][1]));
    out.to_map_v = vec2(real(r.to_map[1][0]), real(r.to_map[1][1]));
    return out;
}

/// @param of  of the point: CornerFrames corners(), and interpolate(a, b, c) between three corners
template <class Kind, class Source>
inline lit::Frame frame_at(const Job<Kind>& job, const Source& of, const ShadingPoint& p) {
    if (job.of.bump == 0 || job.of.has_bumps == 0) return lit::even_frame(p.normal.v, p.normal.sign);
    lit::Frame f = lit::bump_frame(p.normal.v, p.normal.sign, p.tangent.v, p.tangent.sign, job.of.orthogonalize,
                                   job.of.normalize_frames);
    if (job.of.has_bitangents == 0) return f;
    const CornerFrames c = of.corners();
    lit::set_bitangent(f, of.interpolate(c.bitangent[0], c.bitangent[1], c.bitangent[2]), job.of.normalize_frames);
    return f;
}

/// @param c     the map's own coordinates
/// @param side  +1 on the front, -1 from behind
inline HeightPlace height_place(const MaterialJob& job, const TexCoords& c, real side) {
    const TextureView& t = *job.material->map[role_height].view;
    const lit::HeightSense sense = lit::height_sense(side, real(job.relief.level), job.relief.holds_depth);
    return {{&t, sense.scale, sense.offset, nullptr, nullptr}, sense.level, level_of_detail(t, c)};
}

/// @param from_viewer  to the point
/// Moves the texture coordinates to where the ray hits the relief.
inline void enter_relief(const MaterialJob& job, vec3 from_viewer, ShadingPoint& p, Bumps& bumps) {
    const TextureSlot& slot = job.material->map[role_height];
    const int32_t set = slot.texcoord_set == 0 ? 0 : 1;
    TexCoords room;
    const TexCoords& c = transformed(slot, p.texcoords[set], room);
    bumps.place = height_place(job, c, bumps.frame.side);
    const vec3 to_viewer = lit::to_viewer(from_viewer, splat(job.view_direction), job.orthographic);
    bumps.point = lit::relief_point(bumps.place.maps, relief_of(job.relief), c.uv, bumps.place.level,
                                    lit::seen_in_frame(bumps.frame, to_viewer), bumps.place.lod);
    if (job.relief.technique == relief_height) return;
    if (job.material->uses_texcoords[1 - set] != 0) {
        const TexCoords& from = p.texcoords[set];
        TexCoords& other = p.texcoords[1 - set];
        other.uv = other.uv + lit::same_move(from.dx, from.dy, other.dx, other.dy, bumps.point.move);
    }
    p.texcoords[set].uv = p.texcoords[set].uv + bumps.point.move;
}

/// Alpha, < 0 where the relief ends at its texture's edge; there opaque materials are masked, too.
template <class Kind>
inline real alpha_in_silhouette(const Job<Kind>& job, const Bumps& bumps, real alpha) {
    if (!job.has_relief() || job.of.relief.limit_silhouette == 0) return alpha;
    const MaterialView& m = job.material();
    return lit::silhouette_alpha(alpha, bumps.point.is_outside, m.alpha_cutoff < 0 && m.blend == 0);
}

/// The normal is that of the heights, not of a normal map.
template <class Kind>
inline bool uses_slopes(const Job<Kind>& job) {
    return job.has_relief() && (job.of.relief.technique == relief_height || job.normal_map() == nullptr);
}

inline lit::HeightLevels height_levels(const TextureView& t) {
    lit::HeightLevels levels;
    levels.texel = vec2(real(1.0f / float(t.width[0])), real(1.0f / float(t.height[0])));
    levels.last = real(float(t.levels - 1));
    levels.mip = t.levels == 1 ? mip_none : t.mip;
    return levels;
}

/// Where slopes are read: as texel() would read a normal map there, along the longer side of the footprint.
inline lit::Probes slope_probes(const HeightPlace& place, const TexCoords& c, int32_t most) {
    const TextureView& t = *place.maps.height;
    return lit::slope_probes(height_levels(t), c.dx, c.dy, vec2(real(float(t.width[0])), real(float(t.height[0]))),
                             place.lod, most);
}

/// The heights' normal in (tangent, bitangent, normal on the seen side), not unit.
inline vec3 slope_vector(const MaterialJob& job, const ShadingPoint& p, const Bumps& bumps) {
    const lit::HeightLevels levels = height_levels(*bumps.place.maps.height);
    const lit::Relief relief = relief_of(job.relief);
    if (job.anisotropy <= 1)
        return lit::relief_normal(relief, lit::slope_at(bumps.place.maps, levels, bumps.point.uv, bumps.place.lod));
    const TextureSlot& slot = job.material->map[role_height];
    TexCoords room;
    const TexCoords& c = transformed(slot, p.texcoords[slot.texcoord_set == 0 ? 0 : 1], room);
    const lit::Probes probes = slope_probes(bumps.place, c, job.anisotropy);
    return lit::relief_normal(relief, lit::filtered_slope(bumps.place.maps, levels, bumps.point.uv, probes));
}

/// 0..1: how much of light i passes the relief.
template <class Kind>
inline real relief_shadow(const Job<Kind>& job, int32_t i, const Bumps& bumps, const lit::LightSample& light) {
    if (!job.has_relief() || job.of.relief.self_shadow == 0) return real(1.0f);
    if (!job.of.lights[i].casts_shadow) return real(1.0f);
    return lit::relief_shadow(bumps.place.maps, relief_of(job.of.relief), bumps.point,
                              lit::seen_in_frame(bumps.frame, light.l), bumps.place.lod);
}

}  // namespace rakelight::cpu_shading::RL_ISA
