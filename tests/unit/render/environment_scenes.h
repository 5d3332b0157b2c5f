// SPDX-License-Identifier: Apache-2.0
// Surroundings made by formulas, and pictures of simple shapes in them.
#pragma once
#include <cstring>
#include <functional>
#include <utility>

#include <rakelight/render/render.h>

#include "image/maps/environment.h"
#include "prepare/shapes/primitives.h"

namespace rakelight::test {

inline ImageHandle panorama(const std::function<vec3(dvec3)>& light, int height = 64) {
    auto image = std::make_shared<EncodedImage>();
    image->name = "all around";
    image->decode = [light, height](const EncodedImage&, Context&) {
        Pixels p{.width = 2 * height, .height = height, .channels = 3, .component = Component::f32, .is_linear = true};
        p.bytes.resize(p.row_bytes() * std::size_t(height));
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) {
                const vec3 c = light(equirectangular_direction((x + 0.5) / p.width, (y + 0.5) / p.height));
                std::memcpy(p.row(y) + std::size_t(x) * sizeof c, &c, sizeof c);
            }
        return p;
    };
    return image;
}
inline ImageHandle even(float radiance) {
    return panorama([radiance](dvec3) { return vec3{radiance, radiance, radiance}; });
}

inline Scene sphere_in(Environment environment, const std::function<void(Material&)>& change) {
    Scene scene = make_primitive({.tolerance = 1e-4});
    change(scene.materials[0]);
    scene.environment = std::move(environment);
    return scene;
}

inline Frame draw(const Scene& scene, RenderSettings settings = {}, int threads = 2) {
    settings.width = 96, settings.height = 80;
    Context context({.threads = threads});
    return render(scene, settings, context);
}

}  // namespace rakelight::test
