// SPDX-License-Identifier: Apache-2.0
// Reconstructs the height map of a tangent-space normal map.
#pragma once
#include <rakelight/image/image.h>

namespace rakelight {

struct HeightsFromNormals {
    Pixels heights;    ///< gray, u16: 0 the lowest, 65535 the highest point
    double depth = 0;  ///< [widths of the picture] range of the heights; 0: the map is flat (all is 65535)
};

/// Integrates the slopes -n.x / n.z, -n.y / n.z in the sense of least squares: one division in the frequency domain
/// (Frankot & Chellappa 1988, "A Method for Enforcing Integrability in Shape from Shading Algorithms", eq. 21). The map
/// is periodic, so a constant overall slope is removed. Slopes are clamped to 20. Maps of more than 2048 texels per
/// side are reduced to half or a quarter. Sizes with factors other than 2, 3 and 5 are resampled to the next good size
/// (2039 to 2048), because transforms of primes are slow.
/// @param normals  2 rgb - 1, green up unless `green_down`; u8, u16 or f32 of at least 2 channels
/// @throws Error bad_file: over the memory budget Bit-identical for any number of threads.
HeightsFromNormals heights_from_normals(const Pixels& normals, bool green_down, Context& context);

}  // namespace rakelight
