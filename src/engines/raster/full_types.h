// SPDX-License-Identifier: Apache-2.0
// What the full kernel knows beyond the plain one's ShadeJob: lighting models of more parameters, relief, shadows,
// environment, fog. A picture pays for it only where a draw uses some of it. C headers only, as kernel_types.h.
#pragma once
#include <stdint.h>

namespace rakelight::raster {
struct TextureView;

/// How a draw's height map acts.
struct ReliefView {
    int32_t technique;  ///< 0 none, else a number of Bump that reads the height map
    float depth, bias;  ///< [widths of the texture], [1]
    int32_t holds_depth, min_steps, max_steps, refinement_steps, self_shadow, limit_silhouette;
};

/// One light's shadow map: distances from the light, row 0 on top.
struct ShadowView {
    const float* depth;   ///< [faces][size * size]; null: no shadow
    int32_t size, faces;  ///< [texels] of a side; 1, or 6 about a point light
    int32_t is_orthographic;
    float to_map[6][3][4];  ///< rows: position about the eye -> x, y on the map (perspective: times depth), depth
    float texel;            ///< [m] (perspective: per metre of depth) a texel
    float bias;
    int32_t filter;  ///< [texels] radius
};

/// Light from all around.
struct EnvironmentView {
    const TextureView* specular;  ///< octahedral, each level prefiltered for a rougher surface
    float irradiance[9][3];       ///< spherical harmonics of irradiance / pi, scaled for the polynomial in x, y, z
    float turn[2];                ///< cosine and sine of the rotation about +Y
};

struct FogView {
    int32_t kind;  ///< FogKind
    float color[3], start, end, density;
};

/// Frames at the corners of a triangle, beside ShadeTriangle: for lighting in the tangent space of the vertices.
struct CornerFrame {
    float position[3][3], normal[3][3], tangent[3][3];  ///< [corner][x, y, z], about the eye, world axes
    float handedness;
};

struct FullJob {
    int32_t ward_form;  ///< WardForm
    int32_t multiple_scattering;
    int32_t viewer_at_infinity;
    int32_t bump_terms;     ///< 0 both, 1 diffuse, 2 specular
    int32_t tangent_space;  ///< TangentSpace
    int32_t normalize_frames;
    int32_t green_down, centered_normals;
    ReliefView relief;
    const ShadowView* shadows;           ///< [lights]; null: none
    const EnvironmentView* environment;  ///< null: none
    FogView fog;
    const CornerFrame* frames;  ///< beside ShadeJob::triangles; null: not wanted
};

}  // namespace rakelight::raster
