// SPDX-License-Identifier: Apache-2.0
// Direct light of elements from lights (point, spot, directional) and the environment, with shadow rays.
#pragma once
#include <vector>

#include "lighting/light_parameters.h"
#include "radiosity/sky_light.h"

namespace rakelight::radiosity {

class DirectLight {
public:
    /// Ambient lights are ignored, because radiosity computes the indirect light.
    /// @param far_away [m] beyond all surfaces
    DirectLight(const Scene& scene, const raytrace::SurfaceRays& rays, double gap, double far_away, Context& context);
    bool empty() const { return lights_.empty() && sky_.empty(); }
    /// Irradiance / pi, mean over four points of the element.
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
