// SPDX-License-Identifier: Apache-2.0
// The height map that a tangent-space normal map was made from, or the nearest to it.
#pragma once
#include <rakelight/image.h>

namespace rakelight {

struct HeightsFromNormals {
    Pixels heights;    ///< gray, u16: 0 the lowest, 65535 the highest point
    double depth = 0;  ///< [widths of the picture] between them; 0: the map is flat (all is 65535)
};

/// Integrates the slopes -n.x / n.z, -n.y / n.z in the sense of least squares: one division in the frequency domain
/// (Frankot & Chellappa 1988, "A Method for Enforcing Integrability in Shape from Shading Algorithms", eq. 21). The map
/// is taken as periodic; what leans over the whole of it is left out, since a repeated texture cannot go on rising.
/// Slopes steeper than 20 are cut. Maps of more than 2048 texels per side come out at half their size, or a quarter;
/// sides with other factors than 2, 3 and 5 are stretched to the next without, 2039 to 2048, since transforms of primes
/// are slow.
/// @param normals  2 rgb - 1, green up unless `green_down`; u8, u16 or f32 of at least 2 channels
/// @throws Error bad_file: over the memory budget
/// The same bits for any number of threads.
HeightsFromNormals heights_from_normals(const Pixels& normals, bool green_down, Context& context);

}  // namespace rakelight
