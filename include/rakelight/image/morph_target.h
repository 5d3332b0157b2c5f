// SPDX-License-Identifier: Apache-2.0
// Morph targets of a mesh.
#pragma once
#include <string>

#include <rakelight/image/block.h>
#include <rakelight/math/vector.h>

namespace rakelight {

/// A morph target: offsets that are added with a weight.
struct MorphTarget {
    std::string name{};                              ///< for people; may be empty
    Block<vec3> positions{}, normals{}, tangents{};  ///< [V] offsets; each may be empty
    bool operator==(const MorphTarget&) const = default;
};

}  // namespace rakelight
