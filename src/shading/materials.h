// SPDX-License-Identifier: Apache-2.0
// Scene materials -> plain factors, and which of their textures pictures read, with color space and transform.
#pragma once
#include <vector>

#include <rakelight/scene/scene.h>

#include "scene/materials/material_table.h"
#include "shading/material_factors.h"

namespace rakelight::shading {

MaterialFactors material_factors(const Material& material);

/// The roles whose textures pictures show: not those of another model, nor those that a factor of zero silences.
std::vector<const TextureRole*> roles_of(const Material& material);

UvTransform uv_transform(const TextureUse& use);
bool is_identity(const UvTransform& transform);

/// Clearcoat, sheen, an anisotropic highlight, a film, what is seen through it: what is not lit at corners.
bool has_layers(const MaterialFactors& factors);

}  // namespace rakelight::shading
