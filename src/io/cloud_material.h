// SPDX-License-Identifier: Apache-2.0
// The material of formats that have none.
#pragma once
#include <rakelight/scene/scene.h>

namespace rakelight::io {

/// Lambert, both sides; gray, or white where vertices or a texture have colors of their own.
inline Material plain_material(bool has_colors) {
    Material m;
    m.model = MaterialModel::classical;
    m.double_sided = true;
    const float gray = has_colors ? 1.0f : 0.3185468f;  // 0.6 as a display value
    m.base_color = {gray, gray, gray, 1};
    m.classical.ambient = {gray, gray, gray};
    return m;
}

}  // namespace rakelight::io
