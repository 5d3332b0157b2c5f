// SPDX-License-Identifier: Apache-2.0
// The numbers of a draw's material as programs read them: an array of four floats each (rl_material), whose parts the text
// knows by name (m_...). One list makes both.
#pragma once
#include <array>
#include <string>

#include "scene/materials/texture_role_numbers.h"
#include "shading/effect_factors.h"
#include "shading/material_factors.h"

namespace rakelight::opengl {

/// What material and draw give beside MaterialFactors.
struct MaterialNumbers {
    shading::MaterialFactors factors{};
    float mean_roughness = 1;  ///< with the mean of its map
    float mask_cutoff = -1;
    float relief[2]{};  ///< depth, level
    float relief_to_uv[4]{};
    float relief_to_map[4]{};
    float height_levels = 1;
    float body_thickness = 0;             ///< [m] in the world, without its map
    float turn[texture_role_count][4]{};  ///< rows of the texture transforms
    float offset[texture_role_count][2]{};
};

inline constexpr int material_vectors = 29 + 2 * texture_role_count;  ///< at most
using PackedMaterial = std::array<float, 4 * material_vectors>;

PackedMaterial pack(const MaterialNumbers& numbers);
/// `uniform vec4 rl_material[...]` and the names of its parts, RL_TURN_<role>, RL_OFFSET_<role> among them.
const std::string& material_text();

}  // namespace rakelight::opengl
