// SPDX-License-Identifier: Apache-2.0
// What the keys of [[material]] do to a material, for world files and the command line.
#pragma once
#include <functional>
#include <span>

#include <rakelight/scene.h>
#include <rakelight/world.h>

namespace rakelight {

/// Base color as it is, not metallic. A classical material without a highlight (k_s = 0: many have never been given
/// one) becomes an ordinary dielectric: who asks for a roughness is to see it.
Material as_metallic_roughness(const Material& material);

/// Sets what checked keys say, in the order of their table. A material of the other kind is converted first.
/// @param picture  the texture that a key names
void change_material(Material& material, std::span<const WorldValue> values,
                     const std::function<TextureUse(const WorldValue&)>& picture);

}  // namespace rakelight
