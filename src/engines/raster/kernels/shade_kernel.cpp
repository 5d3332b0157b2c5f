// SPDX-License-Identifier: Apache-2.0
// Shading of a run of pixels of one material, `lanes` at a time. Compiled once per instruction set: includes only plain
// data, math/wide.h and what stands on it.
#include "engines/raster/kernels/environment_light.h"
#include "engines/raster/kernels/store.h"
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

/// Flat and Gouraud shading: light that the corners have received, times what the pixel reflects.
inline vec3 add_interpolated(vec3 sum, const ShadeJob& job, const Pixels& p, const lit::Surface& surface) {
    const lit::LightTerms t = lit::corner_terms(surface, interpolate_light(job.lit, p.triangle, p.b));
    return sum + (t.ambient + t.diffuse + t.specular);
}

/// Vectors of pixels that go through the stages side by side: what one waits for another one fills (a pixel's own
/// operations mostly depend on one another). Stages are cut where a root or a division makes what follows wait.
struct Block {
    static constexpr int32_t most = lanes < 32 ? 4 : 2;
    int32_t count;  ///< of vectors
    Pixels pixels[most];
    lit::Surface surface[most];  ///< unlit: only `diffuse`, its own color
    real alpha[most];
    vec3 radiance[most];
};

inline void find_reflectance(const ShadeJob& job, const Pixels& p, lit::Surface& surface, real& alpha) {
    const BaseColor base = base_color(*job.material, p);
    if (job.unlit != 0)
        surface.diffuse = rgb(base.color);
    else
        set_reflectance(job, p, base, surface);
    alpha = job.srgb8 == nullptr ? base.color.w : real(1.0f);  // sRGB codes are opaque
}

inline void find_normals(const ShadeJob& job, Block& b) {
    MappedFrame frames[Block::most];
    const bool is_mapped = is_normal_mapped(job);
    for (int32_t k = 0; k < b.count && is_mapped; ++k) frames[k].mapped = decoded_normal(*job.material, b.pixels[k]);
    for (int32_t k = 0; k < b.count; ++k) find_normal(b.pixels[k], frames[k]);
    for (int32_t k = 0; k < b.count && is_mapped; ++k) find_tangent(job, b.pixels[k], frames[k]);
    for (int32_t k = 0; k < b.count; ++k) b.surface[k].n = lit_side(frames[k], is_mapped);
}

inline void find_surfaces(const ShadeJob& job, int32_t first, Block& b) {
    const MaterialView& m = *job.material;
    const bool needs_normal = (job.lit == nullptr && job.unlit == 0) || job.normal_x != nullptr;
    for (int32_t k = 0; k < b.count; ++k) b.pixels[k].find(job, first + k * lanes);
    for (int32_t k = 0; k < b.count; ++k) find_texcoords(m, b.pixels[k]);
    for (int32_t k = 0; k < b.count; ++k) find_reflectance(job, b.pixels[k], b.surface[k], b.alpha[k]);
    if (!needs_normal) return;
    find_normals(job, b);
    for (int32_t k = 0; k < b.count; ++k) b.surface[k].v = to_viewer(job, b.pixels[k].position);
}

inline void light_surfaces(const ShadeJob& job, Block& b) {
    for (int32_t k = 0; k < b.count; ++k) b.radiance[k] = emission_of(*job.material, b.pixels[k]);
    if (job.unlit != 0 || job.lit != nullptr) {
        for (int32_t k = 0; k < b.count; ++k)
            b.radiance[k] = job.unlit != 0 ? lit::unlit(b.surface[k].diffuse, b.radiance[k])
                                           : add_interpolated(b.radiance[k], job, b.pixels[k], b.surface[k]);
        return;
    }
    const lit::Reflection reflection = reflection_of(job);
    lit::LightSample light[Block::most];
    for (int32_t i = 0; i < job.light_count; ++i) {
        for (int32_t k = 0; k < b.count; ++k) light[k] = lit::sample_light(job.lights[i], b.pixels[k].position);
        for (int32_t k = 0; k < b.count; ++k)
            b.radiance[k] = lit::add_light(b.radiance[k], b.surface[k], light[k], reflection);
    }
}

inline int32_t store_block(const ShadeJob& job, int32_t first, Block& b) {
    int32_t not_finite = 0;
    for (int32_t k = 0; k < b.count; ++k) {
        const int32_t at = first + k * lanes;
        not_finite += store_finite(job, at, b.radiance[k], b.alpha[k]);
        if (job.normal_x != nullptr) store_normal(job, at, b.surface[k].n);
    }
    return not_finite;
}

int32_t shade_full(const ShadeJob* job);  // full_kernel.cpp
void alpha_full(const ShadeJob* job);
void channels(const ChannelJob* job);
void bounds(const ShadeJob* job, LightBox* box);

static int32_t shade(const ShadeJob* job) {
    if (job->full != nullptr) return shade_full(job);
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
    if (job->full != nullptr) return alpha_full(job);
    for (int32_t i = 0; i < job->count; i += lanes) {
        Pixels p(*job, i);
        find_texcoords(*job->material, p);
        store(job->alpha + i, base_color(*job->material, p).color.w);
    }
}

const Kernels* kernels() {
    static constexpr Kernels table = {lanes, shade, alpha, light, channels, bounds, sky};
    return &table;
}

}  // namespace rakelight::raster::RL_ISA
