// SPDX-License-Identifier: Apache-2.0
#include "lighting/light_parameters.h"

#include <algorithm>

namespace rakelight::lighting {

void set_cone(LightParameters& light, float cos_inner, float cos_outer) {
    light.cone_scale = 1.0f / std::max(0.001f, cos_inner - cos_outer);  // 0.001: the extension's own guard
    light.cone_offset = -cos_outer * light.cone_scale;
}

}  // namespace rakelight::lighting
