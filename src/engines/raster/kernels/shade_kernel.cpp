// SPDX-License-Identifier: Apache-2.0
// Shading of a run of pixels of one material, `lanes` at a time. Compiled once per instruction set: includes only plain data,
// math/wide.h and what stands on it.
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
    vec3 position;        ///< relative to the eye
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

inline void find_texcoords(const MaterialView& m, Pixels& p) {
    for (int set = 0; set < 2; ++set)
        if (m.uses_texcoords[set] != 0) find_texcoords(p.records, p.b, set, p.texcoords[set]);
    p.shares_footprint = m.shares_footprint != 0 && p.anisotropy <= 1;
    if (!p.shares_footprint) return;
    const TextureView& t = *m.base_color_map.view;
    const TexCoords c = transformed(m.base_color_map, p.texcoords[m.base_color_map.texcoord_set == 0 ? 0 : 1]);
    find_footprint(t, c, level_of_detail(t, c), t.minify_linear != 0, p.footprint);
}

/// The normal map's texel, 0..1.
inline vec3 normal_texel(const MaterialView& m, const Pixels& p) {
    return rgb(p.shares_footprint ? sample(*m.normal_map.view, p.footprint) : texel(m.normal_map, p));
}

/// What the surface is painted with, vertex color times texture, and that times the material's factor; alpha with the opacity map.
struct BaseColor {
    vec4 paint, color;
};

inline BaseColor base_color(const MaterialView& m, const Pixels& p) {
    BaseColor base;
    const real one(1.0f);
    base.paint = m.vertex_colors != 0 ? interpolate_color(p.records, p.b) : vec4(one, one, one, one);
    if (p.shares_footprint)
        base.paint = base.paint * sample(*m.base_color_map.view, p.footprint);
    else if (m.base_color_map.view != nullptr)
        base.paint = base.paint * texel(m.base_color_map, p);
    base.color = vec4(real(m.base_color[0]), real(m.base_color[1]), real(m.base_color[2]), real(m.base_color[3])) * base.paint;
    if (m.opacity_map.view != nullptr) base.color.w = base.color.w * texel(m.opacity_map, p).x;
    return base;
}

/// Interpolated normal, bumped by the map, on the side that is lit.
inline vec3 shading_normal(const ShadeJob& job, const Pixels& p) {
    const MaterialView& m = *job.material;
    vec3 n = safe_normalize(interpolate3(p.records, p.b, offsetof(ShadeTriangle, normal)));
    if (job.bump != 0 && m.normal_map.view != nullptr) {
        const vec3 along = interpolate3(p.records, p.b, offsetof(ShadeTriangle, tangent));
        const vec3 across = lit::orthogonal_tangent(n, along);
        const vec3 t = job.orthogonalize != 0 ? across : safe_normalize_or(along, across);
        const vec3 mapped = lit::decode_normal(normal_texel(m, p), real(m.normal_scale));
        n = lit::perturb_normal(n, t, p.records(offsetof(ShadeTriangle, handedness)), mapped);
    }
    return n * p.records(offsetof(ShadeTriangle, facing));
}

inline void set_classical(const MaterialView& m, const Pixels& p, vec3 paint, lit::Surface& s) {
    s.ambient = splat(m.ambient) * paint;
    s.specular = splat(m.specular);
    if (m.specular_map.view != nullptr) s.specular = s.specular * rgb(texel(m.specular_map, p));
    s.exponent = real(m.shininess);
}

/// Metallic-roughness as the parameters of a normalized lobe: what classical_from_metallic_roughness() says, per pixel.
inline void set_metallic_roughness(const MaterialView& m, const Pixels& p, vec3 base, lit::Surface& s) {
    real metallic = real(m.metallic), roughness = real(m.roughness);
    if (m.metallic_roughness_map.view != nullptr) {
        const vec4 t = texel(m.metallic_roughness_map, p);
        roughness = roughness * t.y;
        metallic = metallic * t.z;
    }
    s.ambient = base;
    s.diffuse = base * (real(1.0f) - metallic);
    s.specular = mix(splat(m.dielectric_f0), base, metallic);
    s.exponent = exponent_of_roughness(roughness);
}

/// What the material reflects at the pixel: all of the surface but its directions.
inline void set_reflectance(const ShadeJob& job, const Pixels& p, const BaseColor& base, lit::Surface& s) {
    const MaterialView& m = *job.material;
    s.diffuse = rgb(base.color);
    if (m.metallic_roughness != 0)
        set_metallic_roughness(m, p, rgb(base.color), s);
    else
        set_classical(m, p, rgb(base.paint), s);
    if (m.occlusion_map.view != nullptr)
        s.ambient = s.ambient * (real(1.0f) + real(m.occlusion_strength) * (texel(m.occlusion_map, p).x - real(1.0f)));
    s.lobe_scale = lit::lobe_scale(s.exponent, reflection_of(job));
}

/// Flat and Gouraud shading: light that the corners have received, times what the pixel reflects.
inline vec3 add_interpolated(vec3 sum, const ShadeJob& job, const Pixels& p, const lit::Surface& surface) {
    const ReceivedLight received = interpolate_light(job.lit, p.triangle, p.b);
    return sum + (surface.ambient * received.ambient + surface.diffuse * received.diffuse + surface.specular * received.specular);
}

/// First term of the sum.
inline vec3 emission_of(const MaterialView& m, const Pixels& p) {
    const vec3 emission = splat(m.emission);
    return m.emission_map.view != nullptr ? emission * rgb(texel(m.emission_map, p)) : emission;
}

/// What is not finite becomes 0 and is counted, in the first `alive` lanes.
inline real only_finite(real v, int32_t alive, int32_t& not_finite) {
    const mask is_finite = v - v == real(0.0f);
    if (all_lanes(is_finite)) return v;
    not_finite += __builtin_popcount(lane_bits(!is_finite) & ((uint32_t(2) << (alive - 1)) - 1));
    return select(is_finite, v, real(0.0f));
}

/// Linear -> correctly rounded sRGB codes: SrgbEncoder (image/srgb_encoder.h) for a vector.
inline integer srgb8(const uint32_t* table, real linear) {
    const real clamped = min(max(linear, real(srgb_lowest)), real(srgb_highest));
    const integer above = bits_of(clamped) - bits_of(real(srgb_lowest));
    const integer entry = gather_i(table, shift_right_logical(above, srgb_bucket_bits));
    const mask is_over = (above & integer(0xffff)) >= (entry & integer(0x1ffff));
    return shift_right_logical(entry, 24) + select(is_over, integer(1), integer(0));
}

/// Vectors of pixels that go through the stages side by side: what one waits for another one fills (a pixel's own
/// operations mostly depend on one another).
struct Block {
    static constexpr int32_t most = lanes < 32 ? 4 : 2;
    int32_t count;  ///< of vectors
    Pixels pixels[most];
    BaseColor base[most];
    lit::Surface surface[most];
    vec3 radiance[most];
};

inline void find_surfaces(const ShadeJob& job, int32_t first, Block& b) {
    const MaterialView& m = *job.material;
    const bool needs_normal = (job.lit == nullptr && job.unlit == 0) || job.normal_x != nullptr;
    for (int32_t k = 0; k < b.count; ++k) b.pixels[k].find(job, first + k * lanes);
    for (int32_t k = 0; k < b.count; ++k) find_texcoords(m, b.pixels[k]);
    for (int32_t k = 0; k < b.count; ++k) b.base[k] = base_color(m, b.pixels[k]);
    for (int32_t k = 0; k < b.count; ++k) set_reflectance(job, b.pixels[k], b.base[k], b.surface[k]);
    if (!needs_normal) return;
    for (int32_t k = 0; k < b.count; ++k) b.surface[k].n = shading_normal(job, b.pixels[k]);
    for (int32_t k = 0; k < b.count; ++k) b.surface[k].v = to_viewer(job, b.pixels[k].position);
}

inline void light_surfaces(const ShadeJob& job, Block& b) {
    for (int32_t k = 0; k < b.count; ++k) b.radiance[k] = emission_of(*job.material, b.pixels[k]);
    if (job.unlit != 0 || job.lit != nullptr) {
        for (int32_t k = 0; k < b.count; ++k)
            b.radiance[k] = job.unlit != 0 ? lit::unlit(rgb(b.base[k].color), b.radiance[k])
                                           : add_interpolated(b.radiance[k], job, b.pixels[k], b.surface[k]);
        return;
    }
    const lit::Reflection reflection = reflection_of(job);
    for (int32_t i = 0; i < job.light_count; ++i)
        for (int32_t k = 0; k < b.count; ++k)
            b.radiance[k] = lit::add_light(b.radiance[k], b.surface[k],
                                           lit::sample_light(job.lights[i], b.pixels[k].position), reflection);
}

inline void store_colors(const ShadeJob& job, int32_t first, vec3 radiance, real alpha) {
    if (job.srgb8 == nullptr) {
        store(job.red + first, radiance.x);
        store(job.green + first, radiance.y);
        store(job.blue + first, radiance.z);
        store(job.alpha + first, alpha);
        return;
    }
    const integer codes = srgb8(job.srgb_table, radiance.x) | (srgb8(job.srgb_table, radiance.y) << 8) |
                          (srgb8(job.srgb_table, radiance.z) << 16) | integer(int32_t(0xff000000u));
    store(reinterpret_cast<int32_t*>(job.srgb8 + first), codes);
}

inline int32_t store_block(const ShadeJob& job, int32_t first, Block& b) {
    int32_t not_finite = 0;
    for (int32_t k = 0; k < b.count; ++k) {
        const int32_t at = first + k * lanes, alive = job.count - at < lanes ? job.count - at : lanes;
        vec3& radiance = b.radiance[k];
        const real sum = radiance.x + radiance.y + radiance.z;
        if (!all_lanes(sum - sum == real(0.0f))) {
            radiance.x = only_finite(radiance.x, alive, not_finite);
            radiance.y = only_finite(radiance.y, alive, not_finite);
            radiance.z = only_finite(radiance.z, alive, not_finite);
        }
        store_colors(job, at, radiance, b.base[k].color.w);
        if (job.normal_x == nullptr) continue;
        store(job.normal_x + at, b.surface[k].n.x);
        store(job.normal_y + at, b.surface[k].n.y);
        store(job.normal_z + at, b.surface[k].n.z);
    }
    return not_finite;
}

static int32_t shade(const ShadeJob* job) {
    int32_t not_finite = 0;
    Block b;
    for (int32_t i = 0; i < job->count; i += lanes * Block::most) {
        const int32_t vectors = (job->count - i + lanes - 1) / lanes;
        b.count = vectors < Block::most ? vectors : Block::most;
        find_surfaces(*job, i, b);
        light_surfaces(*job, b);
        not_finite += store_block(*job, i, b);
    }
    return not_finite;
}

static void alpha(const ShadeJob* job) {
    for (int32_t i = 0; i < job->count; i += lanes) {
        Pixels p(*job, i);
        find_texcoords(*job->material, p);
        store(job->alpha + i, base_color(*job->material, p).color.w);
    }
}

}  // namespace rakelight::raster::RL_ISA

#include "engines/raster/kernels/channel_kernel.h"  // here: it calls the functions above

namespace rakelight::raster::RL_ISA {

const Kernels* kernels() {
    static constexpr Kernels table = {lanes, shade, alpha, light, channels};
    return &table;
}

}  // namespace rakelight::raster::RL_ISA
