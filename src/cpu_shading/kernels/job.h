// SPDX-License-Identifier: Apache-2.0
// A job as a kernel sees it that is compiled for some of all materials: what it cannot meet is a constant, so that the
// compiler takes it away. Per instruction set.
#pragma once
#include "cpu_shading/kernels/shading_point.h"

namespace rakelight::cpu_shading::RL_ISA {

static_assert(shading::reflects_lambert == RL_LAMBERT && shading::reflects_phong == RL_PHONG &&
              shading::reflects_blinn_phong == RL_BLINN_PHONG && shading::reflects_oren_nayar == RL_OREN_NAYAR &&
              shading::reflects_ward == RL_WARD && shading::reflects_pbr == RL_PBR &&
              shading::reflects_oren_nayar_full == RL_OREN_NAYAR_FULL);
static_assert(shading::form_textbook == RL_TEXTBOOK && shading::form_normalized == RL_NORMALIZED);
static_assert(shading::ward_1992 == RL_WARD_1992 && shading::ward_duer == RL_WARD_DUER &&
              shading::ward_bounded == RL_WARD_BOUNDED);
static_assert(shading::fog_none == RL_NO_FOG && shading::fog_linear == RL_LINEAR_FOG &&
              shading::fog_exponential == RL_EXPONENTIAL_FOG &&
              shading::fog_exponential_squared == RL_EXPONENTIAL_SQUARED_FOG);

/// Which lighting models a kernel knows.
enum class Models { classical, pbr, every };

/// All that a job can ask for.
struct EveryMaterial {
    using UnderLight = EveryMaterial;  ///< the kind whose code finds one light's terms: kinds that do so alike share it
    static constexpr Models models = Models::every;
    static constexpr bool has_bump_choices =
        true;  ///< relief, tangent spaces, bumps on some terms, other readings of maps
    static constexpr bool has_layers =
        true;  ///< clearcoat, sheen, anisotropy, films, transmission, light between the facets
    static constexpr bool has_environment = true;
    static constexpr bool has_fog = true;
    static constexpr TexelFormats formats = TexelFormats::every;
};

/// Lambert, Phong and Blinn-Phong with textures and normal maps.
struct ClassicalMaterial {
    using UnderLight = ClassicalMaterial;
    static constexpr Models models = Models::classical;
    static constexpr bool has_bump_choices = false, has_layers = false, has_environment = false, has_fog = false;
    static constexpr TexelFormats formats = TexelFormats::codes;
};

/// GGX with textures and normal maps: glTF's own material.
struct PbrMaterial {
    using UnderLight = PbrMaterial;
    static constexpr Models models = Models::pbr;
    static constexpr bool has_bump_choices = false, has_layers = false, has_environment = false, has_fog = false;
    static constexpr TexelFormats formats = TexelFormats::codes;
};

/// The same in an environment.
struct PbrInEnvironment : PbrMaterial {
    static constexpr bool has_environment = true;
};

template <class Kind>
struct Job {
    const MaterialJob& of;

    const MaterialView& material() const { return *of.material; }
    int32_t model() const {
        if constexpr (Kind::models == Models::pbr) return RL_PBR;
        if (Kind::models == Models::classical && of.reflection_model > RL_BLINN_PHONG) __builtin_unreachable();
        return of.reflection_model;
    }
    bool is_pbr() const { return model() == RL_PBR; }
    bool is_orthographic() const { return of.orthographic != 0; }
    /// Where directions to the viewer are those of a parallel view.
    int32_t has_parallel_viewer() const { return of.orthographic | of.viewer_at_infinity; }
    const TextureView* normal_map() const { return of.bump != 0 ? material().map[role_normal].view : nullptr; }
    bool has_relief() const { return Kind::has_bump_choices && of.bump != 0 && of.relief.technique != relief_none; }
    bool in_tangent_space() const {
        return Kind::has_bump_choices && of.has_bumps != 0 && of.bump != 0 && of.tangent_space != space_world;
    }
    const EnvironmentView* environment() const { return Kind::has_environment ? of.environment : nullptr; }
    bool has_fog() const { return Kind::has_fog && of.fog.kind != 0; }

    lit::Reflection reflection() const {
        return {model(), of.reflection_form, of.specular_horizon, material().whole_exponent};
    }
    /// What the draw's material has, the same for all its points.
    lit::MaterialTraits traits() const {
        lit::MaterialTraits traits = {of.ward_form, 0, 0, 0, 0, 0, 0, 0};
        if constexpr (Kind::has_bump_choices) traits.has_two_normals = of.bump_terms != shading::bump_both;
        if constexpr (!Kind::has_layers) return traits;
        const MaterialView& m = material();
        traits.has_scattering = of.multiple_scattering;
        if (!is_pbr() || m.metallic_roughness == 0) return traits;
        traits.is_anisotropic = m.anisotropy > 0.0f;
        traits.has_sheen = m.sheen_color[0] > 0.0f || m.sheen_color[1] > 0.0f || m.sheen_color[2] > 0.0f;
        traits.has_coat = m.clearcoat > 0.0f;
        traits.has_transmission = of.behind != nullptr && m.transmission > 0.0f;
        traits.has_iridescence = m.iridescence > 0.0f;
        return traits;
    }
};

/// Of what is lit before there are pixels: no layers.
template <class Kind>
lit::MaterialTraits point_traits(const Job<Kind>& job) {
    return {job.of.ward_form, 0, job.of.multiple_scattering, 0, 0, 0, 0, 0};
}

}  // namespace rakelight::cpu_shading::RL_ISA
