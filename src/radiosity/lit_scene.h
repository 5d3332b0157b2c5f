// SPDX-License-Identifier: Apache-2.0
// The scene with the light of its elements as vertex colors.
#pragma once
#include <rakelight/radiosity/radiosity.h>

#include "radiosity/elements.h"

namespace rakelight::radiosity {

/// Materials are unlit; base color times vertex color is the exitant radiance. Light of elements is averaged to
/// vertices by average() (attributes.h), smooth across objects and sharp at creases. Emissive materials are white with
/// all light in the vertex colors. Triangles with a non-black emission texture show that texture without reflected
/// light. Back sides of two-sided parts are separate meshes.
/// @param meshes [parts] input of the elements
/// @param light   [elements] irradiance / pi
/// @param shown irradiance: the incident light; materials are white without textures, and there are no back sides
Scene lit_scene(Scene scene, const std::vector<Part>& parts, const std::vector<geometry::FineMesh>& meshes,
                const Elements& elements, const std::vector<dvec3>& light, const ColorMaps& colors, LitColors shown,
                Context& context);

/// The scene for vertex-color light: no lights, the environment only as background, the lit pose, no clips.
Scene static_scene(Scene scene);

}  // namespace rakelight::radiosity
