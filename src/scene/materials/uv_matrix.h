// SPDX-License-Identifier: Apache-2.0
// How texture transforms turn and scale coordinates, and the texture to whose coordinates tangents belong.
#pragma once
#include <rakelight/scene/scene.h>

namespace rakelight {

/// The linear part of a TextureTransform: u' = uu u + uv v, v' = vu u + vv v.
struct UvMatrix {
    double uu = 1, uv = 0, vu = 0, vv = 1;
    bool operator==(const UvMatrix&) const = default;
    dvec2 operator*(dvec2 at) const { return {uu * at.x + uv * at.y, vu * at.x + vv * at.y}; }
};
UvMatrix uv_matrix(const TextureTransform& transform);
UvMatrix operator*(const UvMatrix& a, const UvMatrix& b);
/// All zeros where there is none, as for a scale of zero.
UvMatrix inverse(const UvMatrix& m);

/// The texture to whose transformed coordinates a material's tangents belong: the normal map, else the height map, else
/// that of clearcoat normals, else that of anisotropy. Null: none of them.
const TextureUse* tangent_texture(const Material& material);
/// Of its transform.
UvMatrix tangent_matrix(const Material& material);

}  // namespace rakelight
