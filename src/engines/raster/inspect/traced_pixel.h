// SPDX-License-Identifier: Apache-2.0
// What the shading of one pixel went through, as plain data: what kernels/trace_kernel.cpp records.
#pragma once
#include <stdint.h>

#include "scene/materials/texture_role_numbers.h"

namespace rakelight::raster {

/// A texel that a filtered sample came from.
struct TracedTexel {
    int32_t probe;        ///< of an anisotropic filter; 0 without
    int32_t level, x, y;  ///< of the mip chain; from the level's top left texel
    float weight;         ///< all of a sample's sum to 1
    float value[4];       ///< linear
};
inline constexpr int most_texels = 16 * 8 * 4;  ///< 2 x 2 of two levels, of 16 probes, of the four heights of a slope
/// What one texture's value came from. Texels with a weight of 0 are left out.
struct TracedTexels {
    int32_t count;
    TracedTexel texel[most_texels];
};

/// One sampled texture. Meaningless where `is_used` is 0.
struct TracedTexture {
    int32_t is_used;
    float u, v;            ///< after the slot's transform, before wrapping
    int32_t probes;        ///< samples along the footprint's longer side, 1..16
    float axis_u, axis_v;  ///< that side: from the first probe's end to the last one's; 0 for one probe
    float
        level_of_detail;  ///< log2 of texels per pixel, of a probe where there are several; over 0 the picture is shrunk
    float level;          ///< of the mip chain that was read; a fraction lies between two
    float value[4];       ///< filtered, linear; of slopes: the mean of the heights that they are differences of
};

/// What a factor of a term is. src/tools/explain/explain_factors.cpp has words for each.
enum class TracedQuantity : int32_t {
    k_ambient,
    k_diffuse,
    k_specular,
    light_color,      ///< that arrives: of the light, attenuated
    n_dot_l,          ///< 0..1
    n_dot_l_diffuse,  ///< 0..1, with the separate normal of the diffuse term
    n_dot_l_coat,     ///< 0..1, of the coat's normal
    pi,               ///< a light's color is irradiance / pi
    oren_nayar,       ///< A + B ...
    oren_nayar_full,  ///< C1 + ..., and interreflection
    power,            ///< r.v or n.h to the exponent
    energy_factor,    ///< of the normalized forms: pi times the lobe's normalization
    ward_peak,        ///< [1/sr] 1 / (4 pi alpha_x alpha_y)
    ward_exponential,
    ward_divided,  ///< 1 / sqrt(n.l n.v), 1 / (n.l n.v) or 1 / ((l.h)^2 (n.h)^4)
    fresnel,       ///< f0 + (f90 - f0) (1 - v.h)^5
    fresnel_rest,  ///< 1 - that of the dielectric part
    distribution,  ///< [1/sr] D
    visibility,    ///< [1] V
    scattering_color,
    scattering_lost_l,  ///< 1 - E(l)
    scattering_lost_v,  ///< 1 - E(v)
    scattering_mean,    ///< [1/sr] 1 / (pi (1 - E mean))
    sheen_color,
    sheen_lobe,  ///< [1/sr] D V
    sheen_rest,  ///< what the sheen leaves
    coat_reflectance,
    coat_rest,       ///< what the coat lets through
    above,           ///< 0: light or viewer are below the surface; else left out
    seen,            ///< not in shadow; left out where it is 1
    around_diffuse,  ///< reflectances of light from the environment
    around_specular,
    around_sheen,
    around_coat,
    mean_light,  ///< from the environment, weighted by the cosine about the normal
    mean_light_sheen,
    mirrored,  ///< from about the mirror direction
    mirrored_coat,
    own_emission,  ///< the material's
    through,       ///< color that light from behind is seen through
    behind,        ///< light from there, absorbed by the body
    count,
};

struct TracedFactor {
    TracedQuantity quantity;
    int32_t is_color;  ///< 0: all of `value` is one number
    float value[3];
};
inline constexpr int most_factors = 12;

enum class TracedTerm : int32_t { ambient, diffuse, specular, emission };
/// Layers of a material, from below.
enum class TracedLayer : int32_t { base, scattering, sheen, coat };

/// A product that is added to a term. The parts of a term sum to it except for rounding.
struct TracedPart {
    TracedTerm term;
    TracedLayer layer;
    int32_t count;
    TracedFactor factor[most_factors];
};
inline constexpr int most_parts = 6;
/// Of one light, or of what comes from the environment and the emission.
struct TracedParts {
    int32_t count;
    TracedPart part[most_parts];
};

/// One light at the pixel. Vectors in world axes.
struct TracedLight {
    float to_light[3];   ///< unit l
    float distance;      ///< [m]; 0 for lights without a place
    float attenuation;   ///< [1], photometric lights [1/m^2]
    float range_window;  ///< [1] what of it is the window of a range, 1 - (distance / range)^4; 1: there is no range
    float spot;          ///< [1] the cone's factor
    float n_dot_l;
    float lobe_cosine;      ///< n.h (Blinn-Phong, Ward, pbr) or r.v (Phong), 0 for Lambert and Oren-Nayar
    float lobe;             ///< lobe_cosine to the power of the exponent; Ward and pbr: [1/sr] the lobe with F = 1
    float fresnel_weight;   ///< pbr: (1 - v.h)^5
    float specular_factor;  ///< what k_s and the light's color are multiplied by; pbr: Fresnel's term and the color
    float own_ambient[3], own_diffuse[3], own_specular[3];        ///< of the light; photometric: intensity / pi
    float ambient_color[3], diffuse_color[3], specular_color[3];  ///< that arrive: times attenuation and spot
    float ambient[3], diffuse[3], specular[3];                    ///< what is added to the sum
    float sum[3];                                                 ///< after this light
    float seen;  ///< 0..1: how much of its diffuse and specular light is not in shadow
};

struct PixelTrace {
    float barycentric[3];
    float position[3];     ///< [m] relative to the eye, world axes
    float texcoord[2][2];  ///< both sets, as interpolated
    float vertex_color[4];
    float paint[4];         ///< vertex color times base color map
    float base_color[4];    ///< times the material's factor; alpha with the opacity map
    float interpolated[3];  ///< unit normal before the map and before facing
    float tangent[3];       ///< unit, as used by the normal map; 0 without one
    float mapped[3];        ///< decoded texel in tangent space, not unit; 0, 0, 1 without a map
    int32_t is_of_slopes;   ///< `mapped` is the normal of the height map's slopes, on the side that is seen
    float normal[3];        ///< that is lit
    float handedness, facing;
    float view[3];  ///< unit, to the viewer
    float k_ambient[3], k_diffuse[3], k_specular[3], exponent;
    float metallic, roughness;
    float emission[3];  ///< first term of the sum
    int32_t
        is_lit_at_corners;  ///< flat and Gouraud: the sum is emission + k_a received[0] + k_d received[1] + k_s received[2]
    float received[3]
                  [3];  ///< ambient, diffuse, specular light at the pixel, interpolated; 0 where it is lit at the pixel
    float diffuse_normal[3];      ///< that the diffuse term is lit with: `normal` unless bumps act on one term alone
    float relief_texcoord[2][2];  ///< both sets where the ray hits the relief
    float relief_height;  ///< there, as the map has it (steep: of the layer; parallax: under the pixel); -1: no ray is
                          ///< cast
    int32_t has_environment, has_fog, has_relief;
    float openness;          ///< share of light from the environment that ambient occlusion leaves; -1: there is none
    float lobe_alpha[2];     ///< Ward, pbr: widths of the lobe along its axes
    float f90[3];            ///< pbr: reflectance at a grazing angle; k_specular is f0
    float coat, coat_alpha;  ///< pbr: clearcoat's reflectance towards the viewer, its lobe's width
    float coat_normal[3];
    float sheen[3], sheen_alpha;
    float oren_nayar[3];  ///< A and B (C1 and 0.45 s of the full model), 0.17 sigma^2 / (sigma^2 + 0.13)
    int32_t has_transmission;
    float transmitted[3];     ///< the term of what is seen through the surface
    float environment[3][3];  ///< ambient, diffuse and specular term of the light from the environment
    float before_fog[3];      ///< the sum
    float fog_distance, fog_share, fog_color[3];  ///< [m]; color = before_fog fog_share + fog_color (1 - fog_share)
    TracedTexture map[texture_role_count];
    float color[3], alpha;  ///< the kernel's own result
};

}  // namespace rakelight::raster
