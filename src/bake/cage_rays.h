// SPDX-License-Identifier: Apache-2.0
// Rays from LOW's cage inward to HIGH.
#pragma once
#include <optional>

#include "bake/high/high_surface.h"
#include "bake/low/low_surface.h"

namespace rakelight::bake {

struct CageHit {
    HighPoint high;
    double height = 0;  ///< [m] from LOW along the cage's normal, outward > 0
};

/// The first hit that faces outward, by its face or shading normal, from `distance` outside of LOW to the same distance
/// inside. If none does, the first hit of all.
std::optional<CageHit> meet_from_cage(const HighSurface& high, const LowPoint& low, double distance);

/// [m] The proposed cage distance: the 99th percentile of the distances from LOW to the nearest triangle of the same
/// orientation, on either side, plus a quarter. Rays start in up to 16384 evenly distributed triangles of LOW. Without
/// hits: 1/100 of HIGH's diagonal.
double proposed_distance(const HighSurface& high, const LowSurface& low, Context& context);

}  // namespace rakelight::bake
