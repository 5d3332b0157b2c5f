// SPDX-License-Identifier: Apache-2.0
// Points that are lit before there are pixels, as plain data.
#pragma once
#include <cstdint>

#include <rakelight/scene/scene.h>

namespace rakelight::raster {

/// What a point receives, per unit of k_a, k_d and k_s.
struct LitPoint {
    float ambient[3], diffuse[3], specular[3];
};

/// A corner of a triangle that is lit before there are pixels, with the numbers that the lighting was given.
struct LitCorner {
    std::uint32_t vertex = no_index;  ///< of the mesh; none: the face's centroid, used for all three corners
    float position[3], normal[3];     ///< [m] about the eye, and unit, world axes
    LitPoint light;
};
}  // namespace rakelight::raster
