// SPDX-License-Identifier: Apache-2.0
#include "scene/materials/uv_matrix.h"

#include <cmath>

#include "math/functions.h"

namespace rakelight {

UvMatrix uv_matrix(const TextureTransform& transform) {
    const double c = math::cos(transform.rotation_rad), s = math::sin(transform.rotation_rad);
    return {c * transform.scale.x, s * transform.scale.y, -s * transform.scale.x, c * transform.scale.y};
}

UvMatrix operator*(const UvMatrix& a, const UvMatrix& b) {
    return {a.uu * b.uu + a.uv * b.vu, a.uu * b.uv + a.uv * b.vv, a.vu * b.uu + a.vv * b.vu, a.vu * b.uv + a.vv * b.vv};
}

UvMatrix inverse(const UvMatrix& m) {
    const double determinant = m.uu * m.vv - m.uv * m.vu, scale = 1 / determinant;
    if (determinant == 0 || !std::isfinite(scale)) return {0, 0, 0, 0};
    return {m.vv * scale, -m.uv * scale, -m.vu * scale, m.uu * scale};
}

const TextureUse* tangent_texture(const Material& material) {
    const MetallicRoughnessParameters& p = material.metallic_roughness;
    for (const TextureUse* use :
         {&material.normal_texture, &material.height_texture, &p.clearcoat_normal_texture, &p.anisotropy_texture})
        if (*use) return use;
    return nullptr;
}

UvMatrix tangent_matrix(const Material& material) {
    const TextureUse* const use = tangent_texture(material);
    return use ? uv_matrix(use->transform) : UvMatrix{};
}

}  // namespace rakelight
