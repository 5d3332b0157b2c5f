// SPDX-License-Identifier: Apache-2.0
// Denoising of path-traced pictures, guided by what the camera sees first: albedo, normal, position.
//
// Joint NL-means filtering: Rousselle, Manzi, Zwicker 2013, "Robust Denoising using Feature and Color Information"
// (the color weight is that of Rousselle, Knaus, Zwicker 2012, "Adaptive Rendering with Non-Local Means Filtering"):
//
//   out_p = sum over q of w_pq c_q / sum of w_pq,   w_pq = min(exp(-D_pq), exp(-F_pq)),   |q - p|^2 <= 110 (10 pixels)
//   D_pq  = max(0, mean of d_st over the 5 x 5 pairs (s, t) around (p, q) and the 3 channels)
//   d_st  = ((c_s - c_t)^2 - (v_s + min(v_s, v_t))) / (k^2 (v_s + v_t)),   k = 0.6
//   F_pq  = the greatest distance of a feature (below)
//
// c is the light that arrives: color / max(albedo, 0.02), so that textures are left out of the filter and come back sharp. v is
// the variance of c, averaged over 5 x 5 pixels by exp(-F), because variances of a few samples are noisy themselves.
// What differs from the paper: one candidate in place of three; features of constant bandwidth that are not filtered first,
// |n_p - n_q| / 0.3 and |a_p - a_q| / 0.5 (squared); in place of the depth the distance of q's position from the plane of p over
// that of q from p, or the same with p and q exchanged where it is less, divided by 0.15 (squared).
#pragma once
#include <span>

#include <rakelight/context.h>
#include <rakelight/vector.h>

#include "math/isa.h"

namespace rakelight {

/// [px] The greatest distance along x or y of an input pixel that an output pixel depends on. A part of a picture with a border
/// of this width gives the same bits as the whole.
inline constexpr int denoise_radius = 16;

/// All rows [height * width], the top one first. A pixel whose color or variance is negative, not finite or over 1e16 (1e32) is
/// replaced by the mean of pixels with similar features, or black where there are none. Features that are not finite are 0.
struct NoisyPicture {
    int width = 0, height = 0;         ///< [px] >= 0
    std::span<const vec3> color{};     ///< [radiance] linear, mean of the samples
    std::span<const vec3> variance{};  ///< [radiance^2] of the mean: that of the samples / their number
    std::span<const vec3> albedo{};    ///< 0..1, mean of the samples; 1 for those that meet no surface or an emitter
    std::span<const vec3> normal{};    ///< mean of the samples' unit normals; 0 for those that meet no surface
    std::span<const vec3> position{};  ///< [scene units] mean where a surface is met; best seen from the eye; or empty
};

/// Writes the denoised colors. Zero variance leaves colors as they are, but for 1e-5 of rounding.
///
/// Fireflies: a pixel that is more than twice as bright as all but three of its 24 neighbors, and whose brightness is as
/// uncertain as that, is replaced by the mean of similar pixels and not averaged into others. The light that it stands for is
/// lost: pictures with many of them become darker.
/// What only color shows, and pixels along edges, keep more noise than the rest: fewer pixels are like them.
/// The same bits for any number of threads and every instruction set. About 1 MiB a thread beside the spans.
/// @param out  [height * width], not one of the inputs
/// @throws Error usage: a negative size, or a span of another size than the picture's; failed: cancelled;
///         bad_file: more memory than the context's budget allows
void denoise_into(const NoisyPicture& picture, std::span<vec3> out, Context& context, Isa isa = isa_from_environment());

}  // namespace rakelight
