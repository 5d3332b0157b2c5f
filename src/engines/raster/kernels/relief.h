// SPDX-License-Identifier: Apache-2.0
// Height and normal maps in the full kernel: where a ray into the relief meets it, the frame that is lit, and the
// shadows that heights throw on each other: factors and texels given to the lighting text. Per instruction set.
#pragma once
#include "engines/raster/kernels/maps.h"
#include "engines/raster/kernels/tangent_space.h"

namespace rakelight::raster::RL_ISA {

static_assert(shading::relief_none == RL_RELIEF_NONE && shading::relief_height == RL_RELIEF_HEIGHT &&
              shading::relief_parallax == RL_RELIEF_PARALLAX && shading::relief_limited == RL_RELIEF_LIMITED &&
              shading::relief_steep == RL_RELIEF_STEEP && shading::relief_occlusion == RL_RELIEF_OCCLUSION);
static_assert(shading::bump_both == RL_BUMP_BOTH && shading::bump_diffuse == RL_BUMP_DIFFUSE &&
              shading::bump_specular == RL_BUMP_SPECULAR);

/// A job's height map at a vector of pixels.
struct HeightPlace {
    Maps maps;
    real level;  ///< the height that lies in the polygon
    real lod;
};

/// All that bumps are made of at a vector of pixels.
struct Bumps {
    lit::Frame frame;
    HeightPlace place;       ///< set where the job has a relief
    lit::ReliefPoint point;  ///< likewise
};

inline bool has_relief(const ShadeJob& job) { return job.bump != 0 && job.full->relief.technique != relief_none; }

inline lit::Relief relief_of(const ReliefView& r) {
    lit::Relief out;
    out.technique = r.technique;
    out.fewest_layers = r.min_steps, out.most_layers = r.max_steps, out.bisections = r.refinement_steps;
    out.depth = real(r.depth);
    out.to_uv = vec2(real(r.to_uv[0]), real(r.to_uv[1]));
    out.to_map_u = vec2(real(r.to_map[0][0]), real(r.to_map[0][1]));
    out.to_map_v = vec2(real(r.to_map[1][0]), real(r.to_map[1][1]));
    return out;
}

inline lit::Frame frame_at(const ShadeJob& job, const Pixels& p) {
    const SignedVector normal = normal_at(p.records, p.b);
    if (job.bump == 0 || job.full->has_bumps == 0) return lit::even_frame(normal.v, normal.sign);
    const SignedVector tangent = tangent_at(p.records, p.b);
    return lit::bump_frame(normal.v, normal.sign, tangent.v, tangent.sign, job.orthogonalize,
                           job.full->normalize_frames);
}

/// The texture coordinates of the mesh that the height map is read by.
inline const TexCoords& height_texcoords(const ShadeJob& job, const Pixels& p) {
    return p.texcoords[job.material->map[role_height].texcoord_set == 0 ? 0 : 1];
}

/// @param c     the map's own coordinates
/// @param side  +1 on the front, -1 from behind
inline HeightPlace height_place(const ShadeJob& job, const TexCoords& c, real side) {
    const TextureView& t = *job.material->map[role_height].view;
    const lit::HeightSense sense = lit::height_sense(side, real(job.full->relief.level), job.full->relief.holds_depth);
    return {{&t, sense.scale, sense.offset, nullptr, nullptr}, sense.level, level_of_detail(t, c)};
}

/// Moves the texture coordinates to where the ray meets the relief.
inline void enter_relief(const ShadeJob& job, Pixels& p, Bumps& bumps) {
    const TextureSlot& slot = job.material->map[role_height];
    const int32_t set = slot.texcoord_set == 0 ? 0 : 1;
    TexCoords room;
    const TexCoords& c = transformed(slot, p.texcoords[set], room);
    bumps.place = height_place(job, c, bumps.frame.side);
    const vec3 v = lit::seen_in_frame(bumps.frame, to_viewer(job, p.position));
    bumps.point =
        lit::relief_point(bumps.place.maps, relief_of(job.full->relief), c.uv, bumps.place.level, v, bumps.place.lod);
    if (job.full->relief.technique == relief_height) return;
    if (job.material->uses_texcoords[1 - set] != 0) {
        const TexCoords& from = p.texcoords[set];
        TexCoords& other = p.texcoords[1 - set];
        other.uv = other.uv + lit::same_move(from.dx, from.dy, other.dx, other.dy, bumps.point.move);
    }
    p.texcoords[set].uv = p.texcoords[set].uv + bumps.point.move;
}

/// Alpha, < 0 where the relief ends at its texture's edge; there opaque materials are masked, too.
inline real shown_alpha(const ShadeJob& job, const Bumps& bumps, real alpha) {
    if (!has_relief(job) || job.full->relief.limit_silhouette == 0) return alpha;
    const MaterialView& m = *job.material;
    return lit::silhouette_alpha(alpha, bumps.point.is_outside, m.alpha_cutoff < 0 && m.blend == 0);
}

/// Texture coordinates where the ray meets the relief.
inline void find_relief_texcoords(const ShadeJob& job, Pixels& p, Bumps& bumps) {
    const MaterialView& m = *job.material;
    bumps.frame = frame_at(job, p);
    if (!has_relief(job)) return find_texcoords(m, p);
    for (int set = 0; set < 2; ++set)
        if (m.uses_texcoords[set] != 0) find_texcoords(p.records, p.b, set, p.texcoords[set]);
    p.shares_footprint = false;
    enter_relief(job, p, bumps);
}

/// The normal map's vector in (tangent, bitangent, normal), not unit.
inline vec3 map_vector(const ShadeJob& job, const Pixels& p) {
    return lit::decode_mapped(normal_texel(*job.material, p), real(job.material->normal_scale),
                              job.full->centered_normals, job.full->green_down);
}

/// The normal is that of the heights, not of a normal map.
inline bool uses_slopes(const ShadeJob& job) {
    return has_relief(job) &&
           (job.full->relief.technique == relief_height || job.material->map[role_normal].view == nullptr);
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
inline vec3 slope_vector(const ShadeJob& job, const Pixels& p, const Bumps& bumps) {
    const lit::HeightLevels levels = height_levels(*bumps.place.maps.height);
    const lit::Relief relief = relief_of(job.full->relief);
    if (p.anisotropy <= 1)
        return lit::relief_normal(relief, lit::slope_at(bumps.place.maps, levels, bumps.point.uv, bumps.place.lod));
    TexCoords room;
    const TexCoords& c = transformed(job.material->map[role_height], height_texcoords(job, p), room);
    const lit::Probes probes = slope_probes(bumps.place, c, p.anisotropy);
    return lit::relief_normal(relief, lit::filtered_slope(bumps.place.maps, levels, bumps.point.uv, probes));
}

/// The normal that the maps give, on the side that is lit.
inline vec3 bumped_normal(const ShadeJob& job, const Pixels& p, const Bumps& bumps) {
    const lit::Frame& f = bumps.frame;
    if (job.bump != 0 && uses_slopes(job)) return lit::sloped_normal(f, slope_vector(job, p, bumps));
    if (job.bump == 0 || job.material->map[role_normal].view == nullptr) return f.normal * f.side;
    return lit::mapped_normal(f, map_vector(job, p), job.full->tangent_space == space_world);
}

/// Normals, tangent and direction to the viewer.
inline void set_frame(const ShadeJob& job, const Pixels& p, const Bumps& bumps, lit::MaterialSurface& s) {
    lit::set_normals(s, bumped_normal(job, p, bumps), bumps.frame.normal * bumps.frame.side, job.full->bump_terms);
    s.base.v = viewer_in_tangent_space(job, p, bumps.frame, viewer_of(job, p.position));
}

/// Light i as the pixel meets it.
inline lit::LightSample sample_in_frame(const ShadeJob& job, int32_t i, const Pixels& p, const Bumps& bumps) {
    lit::LightSample light = lit::sample_light(job.lights[i], p.position);
    light.l = light_in_tangent_space(job, p, bumps.frame, i, light.l);
    return light;
}

/// 0..1: how much of light i passes the relief.
inline real relief_shadow(const ShadeJob& job, int32_t i, const Bumps& bumps, const lit::LightSample& light) {
    if (!has_relief(job) || job.full->relief.self_shadow == 0) return real(1.0f);
    if (!job.lights[i].casts_shadow) return real(1.0f);
    return lit::relief_shadow(bumps.place.maps, relief_of(job.full->relief), bumps.point,
                              lit::seen_in_frame(bumps.frame, light.l), bumps.place.lod);
}

}  // namespace rakelight::raster::RL_ISA
