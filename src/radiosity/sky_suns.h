// SPDX-License-Identifier: Apache-2.0
// The bright places of an environment, apart from the rest: few fixed directions would miss them, or take them for too much.
#pragma once
#include <vector>

#include <rakelight/vector.h>

namespace rakelight::radiosity {

/// Radiance of all directions, equirectangular as image/environment.h has it.
struct SkyMap {
    int width = 0, height = 0;
    std::vector<dvec3> texels{};  ///< [height * width]
};

/// What comes from one direction.
struct SkySun {
    dvec3 direction;   ///< unit, towards it, in the map's space
    dvec3 irradiance;  ///< on a surface that faces it
};

/// Takes from texels what is above four times the mean luminance of the sky, and gathers it in at most 16 directions: regions of
/// about equal power (Debevec 2005, "A Median Cut Algorithm for Light Probe Sampling").
std::vector<SkySun> take_suns(SkyMap& sky);

/// Means over larger texels, by solid angle. @param width, height  at most those of the sky
SkyMap shrunk(const SkyMap& sky, int width, int height);

}  // namespace rakelight::radiosity
