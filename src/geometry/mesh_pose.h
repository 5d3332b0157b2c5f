// SPDX-License-Identifier: Apache-2.0
// A mesh in bind pose with all that moves its vertices at a moment: for who poses it now, later, or on a GPU.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include <rakelight/block.h>
#include <rakelight/context.h>

#include "geometry/skin.h"

namespace rakelight::geometry {

/// Offsets of a morph target, each [V] or empty, and how much of them counts.
struct PosedTarget {
    float weight = 0;
    Block<vec3> positions{}, normals{}, tangents{};
};

/// First the targets, then the skin.
struct MeshPose {
    Block<vec3> positions{}, normals{};  ///< [V]; normals and tangents may be empty
    Block<vec4> tangents{};
    Block<JointInfluence> influences{}, more_influences{};    ///< as SkinInput has them; without `joints` unused
    std::shared_ptr<const std::vector<JointColumns>> joints;  ///< null: no skin
    std::vector<PosedTarget> targets{};                       ///< all of the mesh, those of weight 0 too

    /// Whether posed_arrays() changes anything.
    bool moves() const;
};

/// By number of the mesh in its scene.
using MeshPoses = std::map<std::uint32_t, MeshPose>;

/// Posed vertices; arrays without animation are those of the mesh.
struct PosedArrays {
    Block<vec3> positions, normals;
    Block<vec4> tangents;
};
PosedArrays posed_arrays(const MeshPose& pose, Context& context);

/// Widens low..high by the positions that are finite.
void extend_box(std::span<const vec3> positions, vec3& low, vec3& high);

/// The box of posed_arrays().positions, to the bit, without their arrays; low > high where none is finite.
struct Box {
    vec3 low, high;
};
Box empty_box();
Box posed_box(const MeshPose& pose, Context& context);

}  // namespace rakelight::geometry
