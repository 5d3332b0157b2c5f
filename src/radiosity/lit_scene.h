// SPDX-License-Identifier: Apache-2.0
// The scene that shows the light of its elements.
#pragma once
#include <rakelight/radiosity.h>

#include "radiosity/elements.h"

namespace rakelight::radiosity {

/// Unlit materials, whose base color times vertex colors is what the elements send out: the light of elements becomes that
/// of vertices by average() (attributes.h), smooth over borders of objects and sharp at creases. Materials that emit are
/// white, with all in the vertex colors; triangles on which an emission texture is not black show it in the base color's place,
/// without what they reflect. Back sides of two-sided parts are meshes of their own.
/// @param meshes  [parts] as the elements were made of
/// @param light   [elements] irradiance / pi
/// @param shown   arriving: the light itself, materials are white and have no textures, back sides are left out
Scene lit_scene(Scene scene, const std::vector<Part>& parts, const std::vector<geometry::FineMesh>& meshes,
                const Elements& elements, const std::vector<dvec3>& light, const ColorMaps& colors, LitColors shown,
                Context& context);

}  // namespace rakelight::radiosity
