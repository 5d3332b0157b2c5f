// SPDX-License-Identifier: Apache-2.0
// Applies keys of [[material]] to a material, for world files and the command line.
#pragma once
#include <functional>
#include <span>

#include <rakelight/io/world.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Keeps the base color, not metallic. A classical material without a highlight (k_s = 0, a common default) becomes an
/// ordinary dielectric, so that a given roughness is visible.
Material as_metallic_roughness(const Material& material);

/// Applies checked keys in the order of their table. A material of the other model is converted first.
/// @param picture the texture of a key
void change_material(Material& material, std::span<const WorldValue> values,
                     const std::function<TextureUse(const WorldValue&)>& picture);

}  // namespace rakelight
