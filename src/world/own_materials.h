// SPDX-License-Identifier: Apache-2.0
// Materials of single objects: a node gets its own meshes and materials; arrays stay shared.
#pragma once
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

class OwnMaterials {
public:
    /// @param scene all meshes have materials; see name_default_material()
    OwnMaterials(Scene& scene, Context& context)
        : scene_(scene), first_own_(std::uint32_t(scene.materials.size())), charge_(context.memory()) {}

    /// The materials with a name ("*": all) of a node's meshes, copied for this node.
    std::vector<std::uint32_t> of(std::uint32_t node, const std::string& name);
    /// The scene gets their memory charges.
    void finish();

private:
    void take_own(std::uint32_t& mesh);

    Scene& scene_;
    std::uint32_t first_own_;
    MemoryCharge charge_;
};

}  // namespace rakelight
