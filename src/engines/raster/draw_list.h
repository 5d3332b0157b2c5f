// SPDX-License-Identifier: Apache-2.0
// What prepare() makes of a scene: a flat list of placed meshes, materials with their textures, lights in the world.
#pragma once
#include <deque>
#include <memory>
#include <vector>

#include <rakelight/scene.h>

#include "engines/raster/kernel_types.h"
#include "engines/raster/textures.h"
#include "geometry/normal_sides.h"
#include "scene/scene_tools.h"

namespace rakelight::raster {

struct EnvironmentMaps;

/// One mesh at one place.
struct Draw {
    std::uint32_t node = none, mesh = none;
    std::uint32_t material = 0;  ///< into DrawList::materials
    dmat4 to_world;              ///< including the mesh's origin
    bool mirrored = false;       ///< det(to_world) < 0
    vec3 low, high;              ///< bounds of the positions, object space
};

/// A material, and which scene material it is (`none`: the default one).
struct DrawMaterial {
    MaterialView view{};
    std::uint32_t scene_material = none;
    bool two_sided = false;  ///< shading::is_two_sided()
    bool classical = false;  ///< its format says nothing about sides (lit_side.h)
};

struct DrawList {
    Scene scene;  ///< keeps the blocks alive
    std::vector<dmat4> node_to_world;
    std::vector<Draw> draws;       ///< of triangles
    std::vector<Draw> line_draws;  ///< of lines and points
    MemoryCharge charge;           ///< pays for matrices and draws
    Bounds bounds;                 ///< of the boxes of both in the world
    std::vector<DrawMaterial> materials;
    std::vector<geometry::NormalSides> normal_sides;     ///< [meshes] of those whose format says nothing about sides
    std::deque<TextureView> views;                       ///< what the slots of the materials point to
    std::shared_ptr<const EnvironmentMaps> environment;  ///< null: none; EnvironmentCache
    EnvironmentView environment_view{};                  ///< of it
};

/// Flattens a valid, posed scene.
DrawList make_draw_list(Scene scene, TextureCache& textures, Context& context);

}  // namespace rakelight::raster
