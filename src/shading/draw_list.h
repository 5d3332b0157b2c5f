// SPDX-License-Identifier: Apache-2.0
// What engines draw of a scene: a flat list of placed meshes with their bounds, and their materials.
#pragma once
#include <bitset>
#include <vector>

#include <rakelight/scene/scene.h>
#include <rakelight/scene/scene_queries.h>

#include "geometry/faults/normal_sides.h"
#include "shading/materials.h"
#include "shading/texture_cache.h"

namespace rakelight::shading {

/// One mesh at one place.
struct Draw {
    std::uint32_t node = no_index, mesh = no_index;
    std::uint32_t material = 0;  ///< into DrawList::materials
    bool mirrored = false;       ///< det(to_world) < 0
    dmat4 to_world;              ///< including the mesh's origin
    vec3 low, high;              ///< bounds of the positions, object space
};

/// A material, and which scene material it is (`no_index`: the default one).
struct DrawMaterial {
    std::uint32_t scene_material = no_index;
    bool is_drawn = false;   ///< else its textures are not looked at
    bool two_sided = false;  ///< is_two_sided() of choices.h
    bool classical = false;  ///< its format says nothing about sides (lit_side.h)
    MaterialFactors factors{};
    float texel_cutoff = -1;               ///< what the mask asks of alpha in its textures; not above 0: nothing
    std::bitset<texture_role_count> maps;  ///< by TextureRoleNumber: it is read, and it could be decoded
};

struct DrawList {
    Scene scene;  ///< keeps the blocks alive
    std::vector<dmat4> node_to_world;
    std::vector<Draw> draws;       ///< of triangles
    std::vector<Draw> line_draws;  ///< of lines and points
    MemoryCharge charge;           ///< pays for matrices and draws
    Bounds bounds;                 ///< of the boxes of both in the world
    std::vector<DrawMaterial> materials;
    std::vector<geometry::NormalSides> normal_sides;  ///< [meshes] of those whose format says nothing about sides

    const DrawMaterial& material(const Draw& draw) const { return materials[draw.material]; }
    /// The default material where it is none of the scene's.
    const Material& scene_material(const DrawMaterial& material) const;
};

/// Flattens a valid, posed scene. What its materials read is decoded into `textures`; what cannot be had is left out and
/// reported, beside what is suspicious about normal maps.
DrawList make_draw_list(Scene scene, TextureCache& textures, const TexturePacker& packer, Context& context);

/// Of the texture that a material has in that role.
TextureKey key_of(const DrawList& list, const DrawMaterial& material, const TextureRole& role);

}  // namespace rakelight::shading
