// SPDX-License-Identifier: Apache-2.0
// What the scene's lights (points, spots, directions) and its environment give to elements, with shadow rays.
#pragma once
#include <vector>

#include "lighting/light_parameters.h"
#include "radiosity/sky_light.h"

namespace rakelight::radiosity {

class DirectLight {
public:
    /// Ambient lights are left out: what they stand for is worked out.
    /// @param far_away  [m] farther than any surface
    DirectLight(const Scene& scene, const raytrace::SurfaceRays& rays, double gap, double far_away, Context& context);
    bool empty() const { return lights_.empty() && sky_.empty(); }
    /// Irradiance / pi, the mean of four places on the element.
    dvec3 operator()(const Element& element) const;

private:
    dvec3 at(dvec3 place, const Element& element) const;

    const raytrace::SurfaceRays& rays_;
    double gap_, far_away_;
    SkyLight sky_;
    dvec3 origin_;
    std::vector<lighting::LightParameters> lights_;
};

}  // namespace rakelight::radiosity
