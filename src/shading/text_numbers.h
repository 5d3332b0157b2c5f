// SPDX-License-Identifier: Apache-2.0
// The choices of the lighting text (src/lighting) as numbers of C++, held against its own by static_assert where both are
// seen. C headers only: kernels of every instruction set read them.
#pragma once
#include <stdint.h>

namespace rakelight::shading {

/// RL_LAMBERT ... RL_OREN_NAYAR_FULL of lighting/material/surface.glsl.
enum ReflectionModel : int32_t {
    reflects_lambert,
    reflects_phong,
    reflects_blinn_phong,
    reflects_oren_nayar,
    reflects_ward,
    reflects_pbr,
    reflects_oren_nayar_full,
};
/// RL_IS_MATTE: without a highlight.
constexpr bool is_matte(int32_t model) {
    return model == reflects_lambert || model == reflects_oren_nayar || model == reflects_oren_nayar_full;
}
constexpr bool is_oren_nayar(int32_t model) {
    return model == reflects_oren_nayar || model == reflects_oren_nayar_full;
}
/// RL_TEXTBOOK, RL_NORMALIZED.
enum ReflectionForm : int32_t { form_textbook, form_normalized };
/// RL_WARD_... of lighting/models/ward.glsl.
enum WardNumber : int32_t { ward_1992, ward_duer, ward_bounded };
/// What a height map is read for: RL_RELIEF_... of lighting/relief/relief.glsl.
enum ReliefTechnique : int32_t {
    relief_none,
    relief_height,
    relief_parallax,
    relief_limited,
    relief_steep,
    relief_occlusion,
};
/// RL_BUMP_... of lighting/material/directions.glsl.
enum BumpTermsNumber : int32_t { bump_both, bump_diffuse, bump_specular };
/// The space that lighting of bumps is done in: no number of the text, but of the kernels that choose its functions.
enum TangentSpaceNumber : int32_t { space_world, space_pixel, space_vertex, space_transposed };
/// RL_..._FOG of lighting/light/fog.glsl.
enum FogNumber : int32_t { fog_none, fog_linear, fog_exponential, fog_exponential_squared };

}  // namespace rakelight::shading
