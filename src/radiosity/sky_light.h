// SPDX-License-Identifier: Apache-2.0
// What the scene's environment gives to elements, where nothing stands before it.
#pragma once
#include <array>

#include "lighting/light_parameters.h"
#include "radiosity/sky_suns.h"
#include "radiosity/visibility.h"

namespace rakelight::radiosity {

class SkyLight {
public:
    /// Dark where the scene has no environment that is a light, or its picture cannot be decoded (a warning in the report).
    SkyLight(const Scene& scene, const raytrace::SurfaceRays& rays, double gap, double far_away, Context& context);
    bool empty() const { return sky_.texels.empty(); }
    /// Irradiance / pi, without that of the suns: the mean of 64 directions by the cosine law.
    dvec3 operator()(const Receiver& receiver) const;
    /// Its bright places, as directional lights.
    const std::vector<lighting::LightParameters>& suns() const { return suns_; }

private:
    void take_map(const Scene& scene, Context& context);
    dvec3 radiance(dvec3 direction) const;

    const raytrace::SurfaceRays& rays_;
    double gap_, far_away_;
    std::array<dvec3, 3> axes_;
    SkyMap sky_;  ///< about as fine as the directions are
    std::vector<lighting::LightParameters> suns_;
};

}  // namespace rakelight::radiosity
