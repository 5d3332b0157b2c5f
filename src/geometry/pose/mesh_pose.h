// SPDX-License-Identifier: Apache-2.0
// A mesh in bind pose with its skin and morph weights at a moment, to be posed now, later, or on a GPU.
#pragma once
#include <cstdint>
#include <map>
#include <span>

#include <rakelight/base/context.h>
#include <rakelight/image/block.h>
#include <rakelight/image/morph_target.h>

#include "geometry/pose/skin.h"

namespace rakelight::geometry {

/// Targets are applied first, then the skin.
struct MeshPose {
    Block<vec3> positions{}, normals{};  ///< [V]; normals and tangents may be empty
    Block<vec4> tangents{};
    Block<JointInfluence> influences{}, more_influences{};  ///< as in SkinInput; unused without `joints`
    Block<JointColumns> joints{};                           ///< empty: no skin
    Block<MorphTarget> targets{};                           ///< all targets of the mesh
    Block<float> weights{};                                 ///< of the targets; 0 where there are fewer

    float weight(std::size_t target) const { return target < weights.size() ? weights[target] : 0; }
    /// Whether posed_arrays() changes anything.
    bool moves() const;
};

/// By mesh index in the scene.
using MeshPoses = std::map<std::uint32_t, MeshPose>;

/// Posed vertices; arrays without animation are those of the mesh.
struct PosedArrays {
    Block<vec3> positions, normals;
    Block<vec4> tangents;
};
PosedArrays posed_arrays(const MeshPose& pose, Context& context);

/// Extends low..high by finite positions.
void extend_box(std::span<const vec3> positions, vec3& low, vec3& high);

/// The bounding box of posed_arrays().positions, bit-identical, without computing arrays; low > high if none is finite.
struct Box {
    vec3 low, high;
};
Box empty_box();
Box posed_box(const MeshPose& pose, Context& context);

}  // namespace rakelight::geometry
