// SPDX-License-Identifier: Apache-2.0
// Extracts the bright regions of an environment, which few fixed directions would miss or overestimate.
#pragma once
#include <vector>

#include <rakelight/math/vector.h>

namespace rakelight::radiosity {

/// Radiance of all directions, equirectangular as in image/environment.h.
struct SkyMap {
    int width = 0, height = 0;
    std::vector<dvec3> texels{};  ///< [height * width]
};

/// Light from one direction.
struct SkySun {
    dvec3 direction;   ///< unit, towards it, in the map's space
    dvec3 irradiance;  ///< on a surface facing it
};

/// Removes luminance above four times the sky's mean from the texels and combines it in at most 16 directions: regions
/// of about equal power (Debevec 2005, "A Median Cut Algorithm for Light Probe Sampling").
std::vector<SkySun> take_suns(SkyMap& sky);

/// Downsamples by solid angle.
/// @param width, height at most those of the sky
SkyMap shrunk(const SkyMap& sky, int width, int height);

}  // namespace rakelight::radiosity
