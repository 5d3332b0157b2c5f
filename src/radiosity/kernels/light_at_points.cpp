// SPDX-License-Identifier: Apache-2.0
// The scalar lighting code in a separate namespace (RL_ISA is `radiositylight`).
#include "radiosity/kernels/light_at_points.h"

#include "lighting/lighting.h"

namespace rakelight::radiosity::RL_ISA {

static_assert(wide::RL_ISA::lanes == 1);

LightAtPoint light_at_point(const lighting::LightParameters& light, const float (&position)[3]) {
    const lighting::RL_ISA::LightSample sample =
        lighting::RL_ISA::sample_light(light, wide::RL_ISA::vec3(position[0], position[1], position[2]));
    const wide::RL_ISA::vec3 color = sample.diffuse * sample.attenuation;
    return {{sample.l.x, sample.l.y, sample.l.z}, {color.x, color.y, color.z}};
}

}  // namespace rakelight::radiosity::RL_ISA
