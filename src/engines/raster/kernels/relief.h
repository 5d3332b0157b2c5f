// SPDX-License-Identifier: Apache-2.0
// Height and normal maps in the full kernel: where a ray into the relief meets it, the frame that is lit, and the
// shadows that heights throw on each other. Per instruction set.
#pragma once
#include "engines/raster/kernels/height_map.h"
#include "engines/raster/kernels/tangent_space.h"

namespace rakelight::raster::RL_ISA {

/// Where the ray meets the relief.
struct ReliefPoint {
    HeightPlace place;
    real height;
    mask is_outside;  ///< of the texture's 0..1
};

/// All that bumps are made of at a vector of pixels.
struct Bumps {
    Frame frame;
    ReliefPoint point;  ///< set where the job has a relief
};

inline bool has_relief(const ShadeJob& job) { return job.bump != 0 && job.full->relief.technique != relief_none; }

inline Frame frame_at(const ShadeJob& job, const Pixels& p) {
    const SignedVector normal = normal_at(p.records, p.b);
    Frame f;
    f.n = f.map_n = safe_normalize(normal.v);
    f.side = normal.sign;
    f.t = f.map_t = f.n;
    f.w = normal.sign;
    if (job.bump == 0 || job.full->has_bumps == 0) return f;
    const SignedVector tangent = tangent_at(p.records, p.b);
    f.t = lit::orthogonal_tangent(f.n, tangent.v);
    f.map_t = job.orthogonalize != 0 ? f.t : safe_normalize_or(tangent.v, f.t);
    f.w = tangent.sign;
    if (job.full->normalize_frames == 0) f.map_n = normal.v, f.map_t = tangent.v;
    return f;
}

/// A direction of the world in (tangent, bitangent, normal on the seen side).
inline vec3 in_frame(const Frame& f, vec3 d) {
    return vec3(dot(d, f.t), dot(d, cross(f.n, f.t)) * f.w, dot(d, f.n) * f.side);
}

/// Texture coordinates of the other set move as far on the screen as those of the height map.
inline vec2 same_move(const TexCoords& from, const TexCoords& to, vec2 move) {
    const real area = from.dx.x * from.dy.y - from.dx.y * from.dy.x;
    const mask has_area = abs(area) > real(1e-30f);
    const real per_area = select(has_area, real(1.0f) / select(has_area, area, real(1.0f)), real(0.0f));
    const real x = (move.x * from.dy.y - move.y * from.dy.x) * per_area;
    const real y = (from.dx.x * move.y - from.dx.y * move.x) * per_area;
    return to.dx * x + to.dy * y;
}

/// The height at which the ray along `run` (lengths along tangent and bitangent for one along the normal) is met.
inline real met_height(const ReliefView& r, const HeightPlace& at, vec2 along, real cosine) {
    if (r.technique < relief_steep) return lit::parallax_height(at.map, at.uv, at.lod);
    const real layers = lit::relief_layers(cosine, r.min_steps, r.max_steps);
    const lit::ReliefHit hit = lit::first_layer(at.map, at.uv, along, at.level, layers, r.max_steps, at.lod);
    if (r.technique == relief_steep) return hit.height;
    return lit::refined_height(at.map, at.uv, along, at.level, hit, r.refinement_steps, at.lod);
}

/// Moves the texture coordinates to where the ray meets the relief.
inline void enter_relief(const ShadeJob& job, Pixels& p, Bumps& bumps) {
    const ReliefView& r = job.full->relief;
    const int32_t set = job.material->height_map.texcoord_set == 0 ? 0 : 1;
    ReliefPoint& point = bumps.point;
    point.place = height_place(job, p.texcoords[set], bumps.frame.side);
    point.height = point.place.level;
    point.is_outside = point.height < real(-1.0f);
    if (r.technique == relief_height) return;
    const vec3 eye = job.orthographic != 0 ? splat(job.view_direction) : -safe_normalize(p.position);
    const vec3 v = in_frame(bumps.frame, eye);
    const vec2 run = (r.technique == relief_limited ? lit::relief_run_limited(v) : lit::relief_run(v)) * real(r.depth);
    const vec2 along = to_map(r, run);
    point.height = met_height(r, point.place, along, v.z);
    const real way = point.height - point.place.level;
    const vec2 move = to_uv(r, run) * way;
    point.place.uv = point.place.uv + along * way;
    if (job.material->uses_texcoords[1 - set] != 0) {
        TexCoords& other = p.texcoords[1 - set];
        other.uv = other.uv + same_move(p.texcoords[set], other, move);
    }
    p.texcoords[set].uv = p.texcoords[set].uv + move;
    const vec2 uv = point.place.uv;
    const real zero(0.0f), one(1.0f);
    point.is_outside = uv.x < zero || uv.x > one || uv.y < zero || uv.y > one;
}

/// Alpha, < 0 where the relief ends at its texture's edge; there opaque materials are masked, too.
inline real shown_alpha(const ShadeJob& job, const Bumps& bumps, real alpha) {
    if (!has_relief(job) || job.full->relief.limit_silhouette == 0) return alpha;
    const MaterialView& m = *job.material;
    const real inside = m.alpha_cutoff < 0 && m.blend == 0 ? real(1.0f) : alpha;
    return select(bumps.point.is_outside, real(-1.0f), inside);
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
inline vec3 mapped_normal(const ShadeJob& job, const Pixels& p) {
    const MaterialView& m = *job.material;
    const vec3 texel = normal_texel(m, p);
    const real scale(m.normal_scale);
    vec3 v =
        job.full->centered_normals != 0 ? lit::decode_normal_centered(texel, scale) : lit::decode_normal(texel, scale);
    if (job.full->green_down != 0) v.y = -v.y;
    return v;
}

/// The normal is that of the heights, not of a normal map.
inline bool uses_slopes(const ShadeJob& job) {
    return has_relief(job) && (job.full->relief.technique == relief_height || job.material->normal_map.view == nullptr);
}

/// The heights' normal in (tangent, bitangent, normal on the seen side), not unit.
inline vec3 sloped_normal(const ShadeJob& job, const Pixels& p, const HeightPlace& place) {
    const TextureSlot& slot = job.material->height_map;
    TexCoords room;
    const TexCoords& c = transformed(slot, p.texcoords[slot.texcoord_set == 0 ? 0 : 1], room);
    return relief_normal(job.full->relief, filtered_slope(place, c, p.anisotropy));
}

/// The normal that the maps give, on the side that is lit.
inline vec3 bumped_normal(const ShadeJob& job, const Pixels& p, const Bumps& bumps) {
    const Frame& f = bumps.frame;
    const bool has_normal_map = job.material->normal_map.view != nullptr;
    if (job.bump == 0) return f.n * f.side;
    if (uses_slopes(job))
        return lit::perturb_normal(f.n * f.side, f.t, f.w * f.side, sloped_normal(job, p, bumps.point.place));
    if (!has_normal_map) return f.n * f.side;
    const bool is_in_world = job.full->tangent_space == space_world;
    const vec3 n =
        lit::perturb_normal(is_in_world ? f.map_n : f.n, is_in_world ? f.map_t : f.t, f.w, mapped_normal(job, p));
    return n * f.side;
}

/// Normals, tangent and direction to the viewer.
inline void set_frame(const ShadeJob& job, const Pixels& p, const Bumps& bumps, lit::MaterialSurface& s) {
    const vec3 n = bumped_normal(job, p, bumps), even = bumps.frame.n * bumps.frame.side;
    s.base.n = job.full->bump_terms == bump_diffuse ? even : n;
    s.diffuse_n = job.full->bump_terms == bump_specular ? even : n;
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
    if (!job.lights[i].casts_shadow || job.lights[i].kind == lighting::LightKind::ambient) return real(1.0f);
    const ReliefView& r = job.full->relief;
    const HeightPlace& at = bumps.point.place;
    const vec3 l = in_frame(bumps.frame, light.l);
    const vec2 along = to_map(r, lit::relief_run(l) * real(r.depth));
    const real ground = max(bumps.point.height, sample_height(at.map, at.uv, at.lod));
    const real layers(float(r.max_steps));  // few layers would show as teeth at the shadows' borders
    return lit::relief_light(at.map, at.uv, ground, along, l.z, layers, r.max_steps, at.lod);
}

}  // namespace rakelight::raster::RL_ISA
