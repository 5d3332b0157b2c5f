// SPDX-License-Identifier: Apache-2.0
// What the full kernel knows beyond the plain one's ShadeJob: lighting models of more parameters, relief, shadows,
// environment, fog. A picture pays for it only where a draw uses some of it. C headers only, as kernel_types.h.
#pragma once
#include <stdint.h>

#include "lighting/albedo_tables.h"
#include "shading/effect_factors.h"
#include "shading/shadow_factors.h"
#include "shading/text_numbers.h"

namespace rakelight::raster {
struct TextureView;

using shading::BumpTermsNumber, shading::bump_both, shading::bump_diffuse, shading::bump_specular;
using shading::ReliefTechnique, shading::relief_none, shading::relief_height, shading::relief_parallax;
using shading::space_world, shading::space_pixel, shading::space_vertex, shading::space_transposed;

using ReliefView = shading::ReliefFactors;
using FogView = shading::FogFactors;

/// Change of depth along x (low 16 bits) and down y (high ones) of a map per width of a texel, as
/// (slope + steepest_slope_on_map) * slope_codes.
inline constexpr float steepest_slope_on_map = 8, slope_codes = 4095;

/// One light's shadow map with its texels.
struct ShadowView : shading::ShadowFactors {
    const float* nearness;  ///< [faces][size * size]
    const int32_t* slopes;  ///< the same: how steep the surface is, steepest_slope_on_map
};

/// Light from all around, with its pictures.
struct EnvironmentView : shading::EnvironmentFactors {
    const TextureView* specular;  ///< octahedral, each level prefiltered for a rougher surface
    const TextureView* sky;       ///< the picture itself, equirectangular
};

/// Frames at the corners of a triangle, beside ShadeTriangle: for lighting in the tangent space of the vertices.
struct CornerFrame {
    float position[3][3], normal[3][3], tangent[3][3];  ///< [corner][x, y, z], about the eye, world axes
    float handedness;
};
inline constexpr int corner_frame_floats = int(sizeof(CornerFrame) / sizeof(float));

struct FullJob {
    int32_t ward_form;  ///< shading::WardNumber
    int32_t multiple_scattering;
    int32_t viewer_at_infinity;
    int32_t bump_terms;     ///< BumpTermsNumber
    int32_t has_bumps;      ///< a normal or height map acts
    int32_t tangent_space;  ///< shading::TangentSpaceNumber
    int32_t normalize_frames;
    int32_t green_down, centered_normals;
    ReliefView relief;
    const ShadowView* shadows;           ///< [maps] LightParameters::shadow says which; null: none
    const EnvironmentView* environment;  ///< null: none
    int32_t has_light_around;            ///< of ambient lights or the environment; 0: what they would give is unused
    FogView fog;
    lighting::AlbedoTables albedo;
    const CornerFrame* frames;  ///< beside ShadeJob::triangles; null: not wanted
};

}  // namespace rakelight::raster
