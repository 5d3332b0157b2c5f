// SPDX-License-Identifier: Apache-2.0
// The numbers of texture roles (material_table.h). C headers only: kernels of every instruction set read them.
#pragma once
#include <stdint.h>

namespace rakelight {

enum TextureRoleNumber : int32_t {
    role_base_color,
    role_normal,
    role_height,
    role_opacity,
    role_occlusion,
    role_emission,
    role_specular,
    role_metallic_roughness,
    role_specular_strength,
    role_specular_color,
    role_anisotropy,
    role_clearcoat,
    role_clearcoat_roughness,
    role_clearcoat_normal,
    role_sheen_color,
    role_sheen_roughness,
    role_transmission,
    role_thickness,
    role_iridescence,
    role_iridescence_thickness,
    texture_role_count
};

}  // namespace rakelight
