// SPDX-License-Identifier: Apache-2.0
// Every texture role of a material, and materials without one.
#pragma once
#include <functional>
#include <string>

#include <rakelight/base/report.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Calls f(TextureUse&) for every texture role of a material, also unused ones.
void for_each_texture_use(Material& m, const std::function<void(TextureUse&)>& f);

/// Removes the emission of a material whose emission texture is missing, because the factor alone would be too bright.
/// Reports it. (Other missing textures count as white: docs/materials.md.)
void drop_emission(Material& m, Report& report, const std::string& file, const std::string& place);

/// Gives meshes without a material an explicit default material of this name, so that it can be changed.
void name_default_material(Scene& scene);

}  // namespace rakelight
