// SPDX-License-Identifier: Apache-2.0
// What the full kernel knows beyond the plain one's ShadeJob: lighting models of more parameters, relief, shadows,
// environment, fog. A picture pays for it only where a draw uses some of it. C headers only, as kernel_types.h.
#pragma once
#include <stdint.h>

#include "lighting/albedo_tables.h"
#include "shading/text_numbers.h"

namespace rakelight::raster {
struct TextureView;

using shading::BumpTermsNumber, shading::bump_both, shading::bump_diffuse, shading::bump_specular;
using shading::ReliefTechnique, shading::relief_none, shading::relief_height, shading::relief_parallax;

/// How a draw's height map acts.
struct ReliefView {
    int32_t technique;  ///< ReliefTechnique
    float depth;        ///< [widths of the texture] from height 0 to 1
    float level;        ///< 0..1: the height that lies in the polygon
    int32_t holds_depth, min_steps, max_steps, refinement_steps, self_shadow, limit_silhouette;
    float to_uv[2];      ///< change of u and v for one width along the tangent and along the bitangent
    float to_map[2][2];  ///< rows: the same of the map's own coordinates, behind the slot's transform
};

/// Change of depth along x (low 16 bits) and down y (high ones) of a map per width of a texel, as
/// (slope + steepest_slope_on_map) * slope_codes.
inline constexpr float steepest_slope_on_map = 8, slope_codes = 4095;

/// One light's shadow map, row 0 on top: how near to the light the nearest surface is. Parallel: minus the distance
/// along the way it shines; else 1 / the distance along the axis of the map, 0: nothing. Linear over the map for a
/// plane.
struct ShadowView {
    const float* nearness;  ///< [faces][size * size]
    const int32_t* slopes;  ///< the same: how steep the surface is, steepest_slope_on_map
    int32_t size, faces;    ///< [texels] of a side; 1, or 6 about +x, -x, +y, -y, +z, -z of the world
    int32_t is_orthographic;
    float to_light[3]
                  [4];  ///< rows: position about the eye -> x to the right, y up, z ahead of the map, about the light
    float texels;       ///< a meter (perspective: a meter at a distance of one) has
    float bias;         ///< of the half texel that surfaces are pushed out by
    int32_t filter;     ///< [texels] radius
};

/// Light from all around.
struct EnvironmentView {
    const TextureView* specular;  ///< octahedral, each level prefiltered for a rougher surface
    float irradiance[9][3];       ///< spherical harmonics of irradiance / pi, scaled for the polynomial in x, y, z
    const TextureView* sky;       ///< the picture itself, equirectangular; null: it is not the background
    float turn[2];                ///< cosine and sine of the rotation about +Y
    float intensity;
};

struct FogView {
    int32_t kind;  ///< shading::FogNumber
    float color[3], start, end, density;
};

/// The numbers of TangentSpace.
enum TangentSpaceNumber : int32_t { space_world, space_pixel, space_vertex, space_transposed };

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
    int32_t tangent_space;  ///< TangentSpaceNumber
    int32_t normalize_frames;
    int32_t green_down, centered_normals;
    ReliefView relief;
    const ShadowView* shadows;           ///< [maps] LightParameters::shadow says which; null: none
    const EnvironmentView* environment;  ///< null: none
    int32_t has_light_around;            ///< of ambient lights or surroundings; 0: nobody asks what they would give
    FogView fog;
    lighting::AlbedoTables albedo;
    const CornerFrame* frames;  ///< beside ShadeJob::triangles; null: not wanted
};

}  // namespace rakelight::raster
