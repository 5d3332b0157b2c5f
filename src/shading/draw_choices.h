// SPDX-License-Identifier: Apache-2.0
// What is chosen for a draw, of its material, its mesh and the settings: once, for every engine.
#pragma once
#include <rakelight/engines/engine.h>

#include "shading/draw_list.h"
#include "shading/effect_factors.h"

namespace rakelight::shading {

/// What it is lit by: the material's own lighting model, else the settings'; never automatic.
Lighting lighting_of(const DrawList& list, const Draw& draw, const RenderSettings& settings);
/// What acts as its bumps, by the maps that could be read and that its mesh has texture coordinates for; none where
/// displacement has made triangles of them.
Bump bump_of(const DrawList& list, const Draw& draw, const RenderSettings& settings);

/// @param aspect  [1] width by height of the height map, which counts where one acts
ReliefFactors relief_of(const DrawList& list, const Draw& draw, const RenderSettings& settings, double aspect);
FogFactors fog_factors(const Fog& fog);

/// Alpha below which a pixel is not there, of masked materials and of reliefs that end at their texture's edge; < 0: all
/// are there.
float mask_cutoff(const MaterialFactors& material, bool limits_silhouette);

/// Of flat and Gouraud shading: whether lighting is evaluated once per face; meshes without normals have no vertices to do it at.
bool is_lit_per_face(const DrawList& list, const Draw& draw, Shading shading);

/// Which sides of a draw are not drawn, and what area on the screen, y down, its front faces have.
struct Culling {
    bool back = false, front = false, front_is_negative = true;
};
Culling culling_of(const DrawList& list, const Draw& draw, const RenderSettings& settings);

/// Where a blended triangle stands in the order in which they are laid, least first: far to near by the middle of its
/// depth keys. Equal ones keep the order of the scene.
inline double blending_place(float farthest_key, float nearest_key) { return double(farthest_key + nearest_key); }

/// Whether some light gives a classical ambient term.
bool has_ambient_light(const Scene& scene);

}  // namespace rakelight::shading
