// SPDX-License-Identifier: Apache-2.0
#include "radiosity/direct_light.h"

#include "math/linear.h"
#include "radiosity/kernels/light_at_points.h"
#include "scene/placement.h"
#include "shading/lights/lights.h"

namespace rakelight::radiosity {

DirectLight::DirectLight(const Scene& scene, const raytrace::SurfaceRays& rays, double gap, double far_away,
                         Context& context)
    : rays_(rays),
      gap_(gap),
      far_away_(far_away),
      sky_(scene, rays, gap, far_away, context),
      origin_(rays.list().bounds.center()) {
    for (const lighting::LightParameters& light : shading::make_lights(scene, world_matrices(scene), origin_))
        if (light.kind != lighting::LightKind::ambient) lights_.push_back(light);
    lights_.insert(lights_.end(), sky_.suns().begin(), sky_.suns().end());
}

dvec3 DirectLight::at(dvec3 place, const Element& e) const {
    const vec3 p = cast<float>(place - origin_);
    const dvec3 start = place + e.face_normal * gap_;
    dvec3 sum{};
    for (const lighting::LightParameters& light : lights_) {
        const LightAtPoint met = radiositylight::light_at_point(light, {p.x, p.y, p.z});
        const dvec3 l{double(met.to_light[0]), double(met.to_light[1]), double(met.to_light[2])};
        const double cosine = dot(e.normal, l);
        const dvec3 color{double(met.radiance[0]), double(met.radiance[1]), double(met.radiance[2])};
        if (!(cosine > 0) || color == dvec3{}) continue;
        const bool is_far = light.kind == lighting::LightKind::directional;
        const dvec3 position{double(light.position[0]), double(light.position[1]), double(light.position[2])};
        const dvec3 to = is_far ? start + l * far_away_ : position + origin_;
        if (light.casts_shadow && rays_.is_blocked(start, to, 1e-5)) continue;
        sum += color * cosine;
    }
    return sum;
}

/// The centers of the four triangles of one midpoint subdivision.
dvec3 DirectLight::operator()(const Element& e) const {
    const dvec3 sky = sky_(receiver_of(e));
    if (lights_.empty()) return sky;
    dvec3 sum = at(e.center, e);
    for (const dvec3 corner : e.corner) sum += at(e.center + (corner - e.center) * 0.5, e);
    return sum * 0.25 + sky;
}

}  // namespace rakelight::radiosity
