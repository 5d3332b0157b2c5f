// SPDX-License-Identifier: Apache-2.0
// Denoising of path-traced pictures, guided by what the camera sees first: albedo, normal, position.
//
// Joint NL-means filtering: Rousselle, Manzi, Zwicker 2013, "Robust Denoising using Feature and Color Information"
// (the color weight is that of Rousselle, Knaus, Zwicker 2012, "Adaptive Rendering with Non-Local Means Filtering"):
//
//   out_p = sum over q of w_pq c_q / sum of w_pq,   w_pq = min(exp(-D_pq), exp(-F_pq)),   |q - p|^2 <= 110 (10 pixels)
// D_pq  = max(0, mean of d_st over the 5 x 5 pairs (s, t) around (p, q) and the 3 channels)
// d_st  = ((c_s - c_t)^2 - (v_s + min(v_s, v_t))) / (k^2 (v_s + v_t)),   k = 0.6
// F_pq  = the greatest distance of a feature (below)
//
// The illumination c is color / max(albedo, 0.02), so that textures are not filtered and stay sharp. Its variance v is
// averaged over 5 x 5 pixels by exp(-F), because variances of few samples are noisy.
//
// Differences from the paper:
// - one candidate instead of three
// - features with constant bandwidth and without prefiltering: |n_p - n_q| / 0.3 and |a_p - a_q| / 0.5 (squared)
// - instead of depth, the distance of q's position from the plane of p over the distance of q from p, or the same with
//   p and q exchanged if less, divided by 0.15 (squared)
#pragma once
#include <span>

#include <rakelight/base/context.h>
#include <rakelight/math/vector.h>

#include "math/isa.h"

namespace rakelight {

/// [px] Radius of the input pixels that affect an output pixel, along x and y. A part of a picture with a border of
/// this width gives a result bit-identical to the whole.
inline constexpr int denoise_radius = 16;

/// All rows [height * width], the top one first. A pixel whose color or variance is negative, not finite or over 1e16
/// (1e32) is replaced by the mean of pixels with similar features, or black. Non-finite features become 0.
struct NoisyPicture {
    int width = 0, height = 0;         ///< [px] >= 0
    std::span<const vec3> color{};     ///< [radiance] linear, mean of the samples
    std::span<const vec3> variance{};  ///< [radiance^2] of the mean: variance of the samples / their number
    std::span<const vec3> albedo{};    ///< 0..1, mean of the samples; 1 for samples without a surface or on an emitter
    std::span<const vec3> normal{};    ///< mean of the samples' unit normals; 0 for samples without a surface
    std::span<const vec3>
        position{};  ///< [scene units] mean over samples with a surface, preferably relative to the eye; or empty
};

/// Writes the denoised colors. Colors with zero variance change only by rounding (1e-5).
///
/// Fireflies: a pixel more than twice as bright as all but three of its 24 neighbors, with an equally large
/// uncertainty, is replaced by the mean of similar pixels and excluded from other means. Its energy is lost, so
/// pictures with many fireflies become darker. Details visible only in the color, and pixels along edges, keep more
/// noise because they have fewer similar pixels. Bit-identical for any number of threads and every instruction set.
/// About 1 MiB per thread besides the spans.
/// @param out  [height * width], not one of the inputs
/// @throws Error usage: a negative size, or a span of the wrong size; failed: cancelled; bad_file: more memory than the
///         context's budget allows
void denoise_into(const NoisyPicture& picture, std::span<vec3> out, Context& context, Isa isa = isa_from_environment());

}  // namespace rakelight
