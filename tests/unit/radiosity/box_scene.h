// SPDX-License-Identifier: Apache-2.0
// Rooms for the tests of radiosity: cubes seen from inside.
#pragma once
#include "support/scene_builder.h"

namespace rakelight::radiosity {

inline Material diffuse(vec3 color, vec3 emission = {0, 0, 0}) {
    Material m;
    m.base_color = {color.x, color.y, color.z, 1};
    m.metallic_roughness.metallic = 0;
    m.emission = emission;
    return m;
}

/// A square of side 2 about `center`, facing along `normal`.
inline dmat4 placed_square(dvec3 center, dvec3 normal) {
    const dvec3 other = std::fabs(normal.y) > 0.5 ? dvec3{1, 0, 0} : dvec3{0, 1, 0};
    const dvec3 u = normalize_or(cross(other, normal), dvec3{1, 0, 0}), v = cross(normal, u);
    return {
        {{u.x, u.y, u.z, 0}, {v.x, v.y, v.z, 0}, {normal.x, normal.y, normal.z, 0}, {center.x, center.y, center.z, 1}}};
}

/// A cube of side 2 about the origin, six objects that face inwards: walls of material 0, the ceiling (+Y) of material 1.
inline Scene room(const Material& walls, const Material& ceiling) {
    Scene scene;
    scene.materials = {walls, ceiling};
    for (const dvec3 side :
         {dvec3{1, 0, 0}, dvec3{-1, 0, 0}, dvec3{0, 1, 0}, dvec3{0, -1, 0}, dvec3{0, 0, 1}, dvec3{0, 0, -1}})
        test::add_object(scene, test::square_mesh(side.y > 0 ? 1 : 0), placed_square(side, -side));
    return scene;
}

}  // namespace rakelight::radiosity
