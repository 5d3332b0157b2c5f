// SPDX-License-Identifier: Apache-2.0
// A material as plain numbers, which equations multiply the texels of its maps by. C headers only: kernels of every
// instruction set read them.
#pragma once
#include <stdint.h>

namespace rakelight::shading {

/// Numbers of metallic-roughness materials that are handed on as they are, by their names in MetallicRoughnessParameters.
#define RL_COPIED_PARAMETERS(X)     \
    X(metallic)                     \
    X(roughness)                    \
    X(anisotropy)                   \
    X(clearcoat)                    \
    X(clearcoat_roughness)          \
    X(clearcoat_normal_scale)       \
    X(sheen_roughness)              \
    X(transmission)                 \
    X(thickness)                    \
    X(iridescence)                  \
    X(iridescence_ior)              \
    X(iridescence_thickness_min_nm) \
    X(iridescence_thickness_max_nm)

struct MaterialFactors {
#define RL_FIELD(name) float name;
    RL_COPIED_PARAMETERS(RL_FIELD)
#undef RL_FIELD
    int32_t unlit, metallic_roughness;  ///< both 0: classical
    float base_color[4], emission[3], ambient[3], specular[3], shininess;
    int32_t whole_exponent;     ///< shininess of classical materials where it is a whole number, else 0
    float dielectric_color[3];  ///< that of the index of refraction times the specular color: may exceed 1
    float specular_strength;    ///< KHR_materials_specular
    float normal_scale, occlusion_strength;
    float alpha_cutoff;        ///< < 0: no mask
    int32_t blend;             ///< 0: alpha is 1
    int32_t vertex_colors;     ///< 0: no mesh with this material has any, all corners are white
    float lobe_roughness;      ///< of classical materials: that of the GGX or Ward lobe as wide as theirs
    float sigma;               ///< [rad] Oren-Nayar; < 0: from roughness
    float ward_alpha[2];       ///< along tangent and bitangent; 0: from roughness and anisotropy
    float anisotropy_axis[2];  ///< KHR_materials_anisotropy: cosine and sine
    float sheen_color[3];
    // Where rays continue (engine trace).
    int32_t mirror;        ///< MirrorNumber, of classical materials
    float filter[3];       ///< k_t of classical materials
    int32_t is_body;       ///< light is refracted and absorbed where it goes through; 0: a thin wall
    float refraction;      ///< index of refraction of a body, of both models
    float attenuation[3];  ///< [1/m] of light in the body
    float dispersion;      ///< 20 / Abbe number of a body
    // What is seen through a surface (engines soft and gl).
    float through_eta[3];   ///< 1 / index of refraction of a body for red, green, blue; 1: a thin wall
    float through_blur;     ///< 0..1: how much of the roughness blurs what is behind
    int32_t through_parts;  ///< a body parts colors
};

inline constexpr float widest_mirror =
    0.1f;  ///< roughness up to which a GGX lobe is a mirror to rays that are followed

/// Mirror of scene.h.
enum MirrorNumber : int32_t { mirror_none, mirror_constant, mirror_fresnel };

/// KHR_texture_transform as the two rows of an affine matrix: u' = uu u + uv v + u0, v' = vu u + vv v + v0.
struct UvTransform {
    float uu, uv, vu, vv, u0, v0;
};

}  // namespace rakelight::shading
