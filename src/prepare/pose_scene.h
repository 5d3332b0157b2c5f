// SPDX-License-Identifier: Apache-2.0
// Applies skins and morph targets: static scenes from animated ones.
#pragma once
#include <array>
#include <map>
#include <optional>

#include <rakelight/base/context.h>
#include <rakelight/prepare/prepare.h>
#include <rakelight/scene/scene.h>

#include "geometry/pose/mesh_pose.h"

namespace rakelight {

/// A static scene, except for the meshes of `poses`, whose vertices are still in bind pose.
struct UnposedScene {
    Scene scene;
    geometry::MeshPoses poses{};
};

/// Poses vertices. Meshes of the same arrays in the same pose share them.
class PoseTaker {
public:
    PoseTaker(UnposedScene& unposed, Context& context);
    /// Of one mesh, which may have no pose.
    void take(std::uint32_t number);
    void take_all();

private:
    using Key = std::array<const void*, 8>;  ///< all blocks of a pose
    struct Posed {
        std::size_t left = 0;  ///< poses of these blocks that are not taken yet; they hold them
        std::optional<geometry::PosedArrays> arrays{};
    };
    static Key key_of(const geometry::MeshPose& pose);

    UnposedScene& unposed_;
    Context& context_;
    std::map<Key, Posed> posed_;
};

/// For validated scenes.
namespace valid {
Scene posed_scene(Scene scene, Context& context);
/// The same before vertices are posed. Their memory is checked, but not charged.
UnposedScene unposed_scene(Scene scene, Context& context);
}  // namespace valid

/// The posed positions of a scene, for spatial queries: as posed_scene(), but without normals and tangents of animated
/// meshes. Nothing: the scene is static.
std::optional<Scene> posed_outline(const Scene& scene, Context& context);

/// Applies Scene::pose to the nodes and removes it; meshes, skins and clips stay.
Scene with_posed_nodes(Scene scene);

}  // namespace rakelight
