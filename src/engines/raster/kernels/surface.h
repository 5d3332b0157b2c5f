// SPDX-License-Identifier: Apache-2.0
// What a run of pixels shows: where each lies, what its material reflects there, its normal and emission. Per
// instruction set.
#pragma once
#include <stddef.h>

#include "engines/raster/kernels/light_kernel.h"
#include "engines/raster/kernels/sample.h"

namespace rakelight::raster::RL_ISA {

/// One vector of pixels on its way.
struct Pixels {
    Records records;
    Barycentrics b;
    TexCoords texcoords[2];
    Footprint footprint;  ///< of base color and normal map where they share it
    int32_t anisotropy;
    bool shares_footprint;
    vec3 position;  ///< relative to the eye
    const int32_t* triangle;

    Pixels() = default;
    Pixels(const ShadeJob& job, int32_t first) { find(job, first); }

    void find(const ShadeJob& job, int32_t first) {
        triangle = job.triangle + first;
        anisotropy = job.anisotropy;
        records.find(reinterpret_cast<const float*>(job.triangles), shade_triangle_floats, triangle);
        const integer pixel = load_i(job.pixel + first);
        real x = to_real(pixel & integer(tile_size - 1)), y = to_real(shift_right_logical(pixel, tile_bits));
        if (job.offset_x != nullptr) x = x + load(job.offset_x + first), y = y + load(job.offset_y + first);
        const Place place = place_of(records, x, y, job.affine != 0, job.orthographic != 0);
        b = place.b;
        const auto ray = [&](int c) { return real(job.ray[c][0]) * x + real(job.ray[c][1]) * y + real(job.ray[c][2]); };
        position = vec3(ray(0), ray(1), ray(2));
        position = job.orthographic != 0 ? position - splat(job.view_direction) * place.depth : position * place.depth;
    }
};

inline vec3 rgb(vec4 v) { return vec3(v.x, v.y, v.z); }
inline vec4 texel(const TextureSlot& slot, const Pixels& p) {
    const TexCoords& at = p.texcoords[slot.texcoord_set == 0 ? 0 : 1];
    return p.anisotropy > 1 ? sample_anisotropic(slot, at, p.anisotropy) : sample(slot, at);
}

/// The neutral texel of a map that is not there.
inline vec4 texel_or_white(const TextureSlot& slot, const Pixels& p) {
    return slot.view != nullptr ? texel(slot, p) : vec4(real(1.0f));
}

inline void find_texcoords(const MaterialView& m, Pixels& p) {
    if (m.uses_texcoords[0] != 0) find_texcoords_of<0>(p.records, p.b, p.texcoords[0]);
    if (m.uses_texcoords[1] != 0) find_texcoords_of<1>(p.records, p.b, p.texcoords[1]);
    p.shares_footprint = m.shares_footprint != 0 && p.anisotropy <= 1;
    if (!p.shares_footprint) return;
    const TextureView& t = *m.map[role_base_color].view;
    TexCoords room;
    const TexCoords& c =
        transformed(m.map[role_base_color], p.texcoords[m.map[role_base_color].texcoord_set == 0 ? 0 : 1], room);
    find_footprint(t, c, level_of_detail(t, c), t.minify_linear != 0, p.footprint);
}

/// The normal map's texel, 0..1.
inline vec3 normal_texel(const MaterialView& m, const Pixels& p) {
    return rgb(p.shares_footprint ? sample(*m.map[role_normal].view, p.footprint) : texel(m.map[role_normal], p));
}

/// In tangent space, not unit.
inline vec3 decoded_normal(const MaterialView& m, const Pixels& p) {
    if (p.shares_footprint && m.normal_scale == 1.0f)
        return lit::decode_twice_normal(rgb(sample(*m.map[role_normal].view, p.footprint, 2.0f)));
    return lit::decode_normal(normal_texel(m, p), real(m.normal_scale));
}

/// What the surface is painted with, vertex color times texture, and that times the material's factor; alpha with the opacity map.
struct BaseColor {
    vec4 paint, color;
};

[[gnu::always_inline]] inline BaseColor base_color(const MaterialView& m, const Pixels& p) {
    BaseColor base;
    const real one(1.0f);
    base.paint = vec4(one, one, one, one);
    if (m.map[role_base_color].view != nullptr)
        base.paint =
            p.shares_footprint ? sample(*m.map[role_base_color].view, p.footprint) : texel(m.map[role_base_color], p);
    if (m.vertex_colors != 0) base.paint = interpolate_color(p.records, p.b) * base.paint;
    base.color =
        vec4(real(m.base_color[0]), real(m.base_color[1]), real(m.base_color[2]), real(m.base_color[3])) * base.paint;
    if (m.map[role_opacity].view != nullptr) base.color.w = base.color.w * texel(m.map[role_opacity], p).x;
    return base;
}

/// The frame of a pixel's normal map: unit normal and tangent, each with the sign that follows it in the record.
struct MappedFrame {
    SignedVector normal, tangent;
    vec3 mapped;  ///< of the map, in the frame
};

inline bool is_normal_mapped(const ShadeJob& job) {
    return job.bump != 0 && job.material->map[role_normal].view != nullptr;
}

inline void find_normal(const Pixels& p, MappedFrame& f) {
    f.normal = normal_at(p.records, p.b);
    f.normal.v = safe_normalize(f.normal.v);
}

inline void find_tangent(const ShadeJob& job, const Pixels& p, MappedFrame& f) {
    f.tangent = tangent_at(p.records, p.b);
    f.tangent.v = lit::map_tangent(f.normal.v, f.tangent.v, job.orthogonalize);
}

/// On the side that is lit.
inline vec3 lit_side(const MappedFrame& f, bool is_mapped) {
    const vec3 n = is_mapped ? lit::perturb_normal(f.normal.v, f.tangent.v, f.tangent.sign, f.mapped) : f.normal.v;
    return n * f.normal.sign;
}

/// Interpolated normal, bumped by the map, on the side that is lit: the stages above in one.
inline vec3 shading_normal(const ShadeJob& job, const Pixels& p) {
    MappedFrame f;
    const bool is_mapped = is_normal_mapped(job);
    if (is_mapped) f.mapped = decoded_normal(*job.material, p);
    find_normal(p, f);
    if (is_mapped) find_tangent(job, p, f);
    return lit_side(f, is_mapped);
}

/// What a metallic-roughness material is at a pixel, for every lighting model.
inline lit::MetallicRoughness metallic_roughness_at(const MaterialView& m, const Pixels& p) {
    lit::MetallicRoughness at;
    at.metallic = real(m.metallic), at.roughness = real(m.roughness);
    lit::apply_metallic_roughness(at, texel_or_white(m.map[role_metallic_roughness], p));
    lit::apply_specular(at, splat(m.dielectric_color), real(m.specular_strength),
                        texel_or_white(m.map[role_specular_color], p),
                        texel_or_white(m.map[role_specular_strength], p));
    return at;
}

inline void set_classical(const MaterialView& m, const Pixels& p, vec3 paint, lit::Surface& s) {
    lit::set_classical_reflectance(s, splat(m.ambient), splat(m.specular), real(m.shininess), paint,
                                   texel_or_white(m.map[role_specular], p));
}

inline real occlusion_of(const MaterialView& m, const Pixels& p) {
    return lit::occlusion_factor(real(m.occlusion_strength), texel_or_white(m.map[role_occlusion], p));
}

/// What the material reflects at the pixel: all of the surface but its directions. Metallic-roughness as the parameters
/// of a normalized lobe.
inline void set_reflectance(const ShadeJob& job, const Pixels& p, const BaseColor& base, lit::Surface& s) {
    const MaterialView& m = *job.material;
    s.diffuse = rgb(base.color);
    if (m.metallic_roughness != 0) {
        const lit::MetallicRoughness at = metallic_roughness_at(m, p);
        lit::set_metallic_reflectance(s, at, rgb(base.color));
        s.exponent = lit::exponent_of_roughness(at.roughness);
    } else {
        set_classical(m, p, rgb(base.paint), s);
    }
    if (m.map[role_occlusion].view != nullptr)
        lit::apply_occlusion(s, real(m.occlusion_strength), texel(m.map[role_occlusion], p));
    s.lobe_scale = lit::lobe_scale(s.exponent, reflection_of(job));
}

/// First term of the sum.
inline vec3 emission_of(const MaterialView& m, const Pixels& p) {
    return lit::emission_of(splat(m.emission), texel_or_white(m.map[role_emission], p));
}

}  // namespace rakelight::raster::RL_ISA
