// SPDX-License-Identifier: Apache-2.0
// Light of elements from the unoccluded environment.
#pragma once
#include <array>

#include "lighting/light_parameters.h"
#include "radiosity/sky_suns.h"
#include "radiosity/visibility.h"

namespace rakelight::radiosity {

class SkyLight {
public:
    /// Zero if no environment lights the scene, or its picture cannot be decoded (with a warning).
    SkyLight(const Scene& scene, const raytrace::SurfaceRays& rays, double gap, double far_away, Context& context);
    bool empty() const { return sky_.texels.empty(); }
    /// Irradiance / pi without the suns: mean over 64 cosine-weighted directions.
    dvec3 operator()(const Receiver& receiver) const;
    /// Its bright regions as directional lights.
    const std::vector<lighting::LightParameters>& suns() const { return suns_; }

private:
    void take_map(const Scene& scene, Context& context);
    dvec3 radiance(dvec3 direction) const;

    const raytrace::SurfaceRays& rays_;
    double gap_, far_away_;
    std::array<dvec3, 3> axes_;
    SkyMap sky_;  ///< resolution similar to the directions
    std::vector<lighting::LightParameters> suns_;
};

}  // namespace rakelight::radiosity
