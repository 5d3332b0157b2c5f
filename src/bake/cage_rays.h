// SPDX-License-Identifier: Apache-2.0
// From LOW to HIGH: rays from the cage inward.
#pragma once
#include <optional>

#include "bake/high_surface.h"
#include "bake/low_surface.h"

namespace rakelight::bake {

struct CageHit {
    HighPoint high;
    double height = 0;  ///< [m] from LOW along the cage's normal, outward > 0
};

/// The first triangle that faces outward, by itself or by its shading normal, from `distance` outside of LOW to as far inside; the
/// first of all where none does.
std::optional<CageHit> meet_from_cage(const HighSurface& high, const LowPoint& low, double distance);

/// [m] How far the cage should stand off: what 99 % of rays from LOW need to the nearest triangle that faces as LOW does, on
/// either side, and a quarter more. Rays start in up to 16384 triangles, spread evenly over LOW. A hundredth of HIGH's diagonal
/// where none meets any.
double proposed_distance(const HighSurface& high, const LowSurface& low, Context& context);

}  // namespace rakelight::bake
