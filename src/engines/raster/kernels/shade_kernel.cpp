// SPDX-License-Identifier: Apache-2.0
// Shading of a run of pixels of one material, `lanes` at a time. Compiled once per instruction set: includes only plain data,
// math/wide.h and what stands on it.
#include "engines/raster/kernels/channel_kernel.h"
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

/// Flat and Gouraud shading: light that the corners have received, times what the pixel reflects.
inline vec3 add_interpolated(vec3 sum, const ShadeJob& job, const Pixels& p, const lit::Surface& surface) {
    const ReceivedLight received = interpolate_light(job.lit, p.triangle, p.b);
    return sum + (surface.ambient * received.ambient + surface.diffuse * received.diffuse + surface.specular * received.specular);
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

const Kernels* kernels() {
    static constexpr Kernels table = {lanes, shade, alpha, light, channels};
    return &table;
}

}  // namespace rakelight::raster::RL_ISA
