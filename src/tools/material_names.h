// SPDX-License-Identifier: Apache-2.0
// The textures of a material by role.
#pragma once
#include <utility>
#include <vector>

#include <rakelight/scene/scene.h>

namespace rakelight {

/// Role (as in JSON: "base_color", "normal", ...) and use; only those that name a texture.
std::vector<std::pair<const char*, TextureUse>> named_texture_uses(const Material& material);

const char* name_of(MaterialModel model);
const char* name_of(AlphaMode mode);
const char* name_of(LightType type);

}  // namespace rakelight
