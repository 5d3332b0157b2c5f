// SPDX-License-Identifier: Apache-2.0
#include "prepare/back_side.h"

#include <utility>

#include "math/linear.h"

namespace rakelight {

Mesh back_side(Mesh mesh) {
    std::vector<std::uint32_t> indices(mesh.indices.begin(), mesh.indices.end());
    for (std::size_t i = 0; i < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
    std::vector<vec3> normals(mesh.normals.begin(), mesh.normals.end());
    for (vec3& n : normals) n = -n;
    mesh.indices = std::move(indices), mesh.normals = std::move(normals);
    mesh.tangents = {};
    return mesh;
}

}  // namespace rakelight
