// SPDX-License-Identifier: Apache-2.0
// What the scene's environment gives to elements, where nothing stands before it.
#pragma once
#include <array>

#include "image/mip_chain.h"
#include "radiosity/visibility.h"

namespace rakelight::radiosity {

class SkyLight {
public:
    /// Dark where the scene has no environment that is a light, or its picture cannot be decoded (a warning in the report).
    SkyLight(const Scene& scene, const raytrace::SurfaceRays& rays, double gap, double far_away, Context& context);
    bool empty() const { return texels_.empty(); }
    /// Irradiance / pi: the mean of 64 directions by the cosine law.
    dvec3 operator()(const Receiver& receiver) const;

private:
    dvec3 radiance(dvec3 direction) const;

    const raytrace::SurfaceRays& rays_;
    double gap_, far_away_;
    std::array<dvec3, 3> axes_;
    int width_ = 0, height_ = 0;
    std::vector<dvec3> texels_;  ///< of a small version of the picture, times its intensity
};

}  // namespace rakelight::radiosity
