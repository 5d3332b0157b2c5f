// SPDX-License-Identifier: Apache-2.0
// A square that is lit and seen along its normal, where every lobe has a closed form.
#pragma once
#include "unit/raster/drawn.h"

namespace rakelight::test {

/// A square that faces an orthographic camera, lit along the view.
inline Scene facing_square(const Material& m, vec3 ambient = {0, 0, 0}, vec3 color = {1, 1, 1}) {
    Scene scene;
    scene.materials = {m};
    add_object(scene, square_mesh(0));
    Light around;
    around.type = LightType::ambient;
    around.ambient = ambient;
    scene.lights = {directional({0, 0, -1}, color), around};
    return scene;
}

inline Material metallic(float metal, float roughness, vec3 base = {0.5f, 0.25f, 1}) {
    Material m;
    m.base_color = {base.x, base.y, base.z, 1};
    m.metallic_roughness.metallic = metal, m.metallic_roughness.roughness = roughness;
    return m;
}

inline vec4 middle(const Scene& scene, Lighting lighting, bool compensated = false, Shading shading = Shading::phong) {
    RenderSettings s{.width = 32, .height = 32, .shading = shading, .lighting = lighting};
    s.multiple_scattering = compensated;
    return pixel(draw(scene, flat_camera(), s), 16, 16);
}

}  // namespace rakelight::test
