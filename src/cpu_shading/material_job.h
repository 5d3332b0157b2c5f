// SPDX-License-Identifier: Apache-2.0
// A material, the lights and the choices that points of one draw are shaded by: all but the points themselves. Plain data,
// C headers only: read by kernels of every instruction set.
#pragma once
#include <stdint.h>

#include "cpu_shading/texture_view.h"
#include "lighting/albedo_tables.h"
#include "lighting/light_parameters.h"
#include "scene/materials/texture_role_numbers.h"
#include "shading/effect_factors.h"
#include "shading/text_numbers.h"

namespace rakelight::cpu_shading {

using shading::relief_none, shading::relief_height, shading::relief_parallax;
using shading::space_world, shading::space_pixel, shading::space_vertex, shading::space_transposed;

/// Which kernel shades a draw: each is the same source compiled for some of all materials (kernels/job.h).
enum KernelNumber : int32_t { kernel_classical, kernel_pbr, kernel_pbr_environment, kernel_every };

struct MaterialView : shading::MaterialFactors {
    uint32_t shared_maps;           ///< [bits by TextureRoleNumber] read where the base color map is, texel by texel
    int32_t has_float_maps;         ///< some map has float texels
    int32_t occlusion_in_metallic;  ///< 1: the occlusion map is the metallic-roughness map's picture, read alike
    int32_t uses_texcoords[2];      ///< some map is read by the set
    TextureSlot map[texture_role_count];  ///< by TextureRoleNumber
};

/// Light from the environment, with its pictures.
struct EnvironmentView : shading::EnvironmentFactors {
    const TextureView* specular;  ///< octahedral, each level prefiltered for a rougher surface
    const TextureView* sky;       ///< the picture itself, equirectangular
};

/// What is behind transmissive surfaces.
struct BehindView : shading::BehindFactors {
    const TextureView* picture;
};

struct MaterialJob {
    const MaterialView* material;
    const lighting::LightParameters* lights;
    int32_t light_count;
    int32_t reflection_model;  ///< shading::ReflectionModel
    int32_t reflection_form;   ///< shading::ReflectionForm
    int32_t specular_horizon;
    int32_t ward_form;  ///< shading::WardNumber
    int32_t multiple_scattering;
    int32_t unlit;       ///< own color: no lighting
    int32_t anisotropy;  ///< most texture samples along a footprint's longer side, 1..16

    int32_t orthographic, viewer_at_infinity;
    float view_direction[3];  ///< towards the viewer, for orthographic views

    int32_t bump;              ///< 0: normal and height maps are ignored
    int32_t has_bumps;         ///< a normal or height map acts, or would where lighting is evaluated at the pixels
    int32_t bump_terms;        ///< shading::BumpTermsNumber
    int32_t tangent_space;     ///< shading::TangentSpaceNumber
    int32_t has_bitangents;    ///< normal maps act along the mesh's own bitangents
    int32_t orthogonalize;     ///< 0: tangents are used as they are interpolated, only made unit
    int32_t normalize_frames;  ///< 0: normal maps act in normals and tangents as they are interpolated
    int32_t green_down, centered_normals;
    shading::ReliefFactors relief;

    const EnvironmentView* environment;  ///< null: none
    /// [points] 0..1: share of the light from the environment that surfaces nearby let through; null: all of it
    const float* openness;
    int32_t has_light_around;  ///< of ambient lights or the environment; 0: what they would give is unused
    const BehindView* behind;  ///< null: what transmits is drawn opaque, or rays continue
    float thickness_scale;     ///< of the draw: lengths in the world over those of its mesh
    shading::FogFactors fog;
    lighting::AlbedoTables albedo;
};

}  // namespace rakelight::cpu_shading
