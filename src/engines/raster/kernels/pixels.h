// SPDX-License-Identifier: Apache-2.0
// The pixels of a job as the points that are shaded: what cpu_shading/kernels/shade_points.h calls a Source. Per
// instruction set.
#pragma once
#include <stddef.h>

#include "cpu_shading/kernels/shade_points.h"
#include "engines/raster/kernels/interpolate.h"

namespace rakelight::raster::RL_ISA {
namespace cpu = rakelight::cpu_shading::RL_ISA;
using cpu::ShadingPoint, cpu::splat, cpu::rgb;

/// One vector of pixels: their triangles, and where they lie in them.
struct Pixels {
    Records records;
    Barycentrics b;
    const int32_t* triangle;

    Pixels() = default;

    /// @return their position about the eye
    vec3 find(const ShadeJob& job, int32_t first) {
        triangle = job.triangle + first;
        records.find(reinterpret_cast<const float*>(job.triangles), shade_triangle_floats, triangle);
        const integer pixel = load_i(job.pixel + first);
        real x = to_real(pixel & integer(tile_size - 1)), y = to_real(shift_right_logical(pixel, tile_bits));
        if (job.offset_x != nullptr) x = x + load(job.offset_x + first), y = y + load(job.offset_y + first);
        const Place place = place_of(records, x, y, job.affine != 0, job.orthographic != 0);
        b = place.b;
        const auto ray = [&](int c) { return real(job.ray[c][0]) * x + real(job.ray[c][1]) * y + real(job.ray[c][2]); };
        const vec3 position(ray(0), ray(1), ray(2));
        return job.orthographic != 0 ? position - splat(job.view_direction) * place.depth : position * place.depth;
    }
};

/// A vector's triangles, for what is found at their vertices: CornerFrame.
struct PixelTriangles {
    const ShadeJob& job;
    const Pixels& pixels;

    cpu::CornerFrames corners() const {
        const Records records(reinterpret_cast<const float*>(job.frames), corner_frame_floats, pixels.triangle);
        real a[corner_frame_floats];
        records.each<corner_frame_floats>(0, [&](int part, const part::real(&v)[corner_frame_floats]) {
            for (int k = 0; k < corner_frame_floats; ++k) part_of(a[k], part) = v[k];
        });
        const auto vector = [&a](int first) { return vec3(a[first], a[first + 1], a[first + 2]); };
        cpu::CornerFrames out;
        out.handedness = a[27];
        for (int k = 0; k < 3; ++k)
            out.position[k] = vector(3 * k), out.normal[k] = vector(9 + 3 * k), out.tangent[k] = vector(18 + 3 * k),
            out.bitangent[k] = vector(28 + 3 * k);
        return out;
    }
    vec3 from_viewer(vec3 position) const { return position; }
    vec3 interpolate(vec3 a, vec3 b, vec3 c) const { return a + (b - a) * pixels.b.b1 + (c - a) * pixels.b.b2; }
};

/// The light of each pixel's triangle at the pixel, perspective-correct.
inline lit::LightTerms interpolate_light(const LitTriangle* triangles, const int32_t* triangle, const Barycentrics& b) {
    const Records records(reinterpret_cast<const float*>(triangles), lit_triangle_floats, triangle);
    lit::LightTerms terms;
    terms.ambient = interpolate3(records, b, offsetof(LitTriangle, ambient));
    terms.diffuse = interpolate3(records, b, offsetof(LitTriangle, diffuse));
    terms.specular = interpolate3(records, b, offsetof(LitTriangle, specular));
    return terms;
}

/// `most` vectors of pixels from `first` on.
template <int32_t most>
struct PixelSource {
    const ShadeJob& job;
    int32_t first;
    Pixels pixels[most];

    PixelSource(const ShadeJob& from, int32_t first_pixel) : job(from), first(first_pixel) {}

    void place(int32_t k, ShadingPoint& p) { p.position = pixels[k].find(job, first + k * lanes); }
    void texcoords(int32_t k, int32_t set, TexCoords& to) const {
        find_texcoords(pixels[k].records, pixels[k].b, set, to);
    }
    vec4 color(int32_t k) const { return interpolate_color(pixels[k].records, pixels[k].b); }
    SignedVector normal(int32_t k) const { return normal_at(pixels[k].records, pixels[k].b); }
    SignedVector tangent(int32_t k) const { return tangent_at(pixels[k].records, pixels[k].b); }
    real openness(int32_t k) const { return load(job.openness + first + k * lanes); }
    PixelTriangles of(int32_t k) const { return {job, pixels[k]}; }
    vec3 weights(int32_t k) const {
        const Barycentrics& b = pixels[k].b;
        return vec3(real(1.0f) - b.b1 - b.b2, b.b1, b.b2);
    }
    bool is_lit_at_corners() const { return job.lit != nullptr; }
    lit::LightTerms corner_light(int32_t k) const {
        return interpolate_light(job.lit, pixels[k].triangle, pixels[k].b);
    }
};

}  // namespace rakelight::raster::RL_ISA
