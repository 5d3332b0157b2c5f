// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/lights/tile_lights.h"

#include <algorithm>

#include "engines/raster/tile.h"

namespace rakelight::raster {
namespace {

constexpr std::int32_t pixels_per_list = 256;  ///< a multiple of all numbers of lanes
static_assert(pixels_per_list % batch_padding == 0);

template <class T>
void advance(T*& array, std::int32_t by) {
    if (array) array += by;
}

/// The pixels from `first` on, at most pixels_per_list of them.
ShadeJob part_of(const ShadeJob& job, std::int32_t first) {
    ShadeJob part = job;
    part.count = std::min(job.count - first, pixels_per_list);
    advance(part.pixel, first), advance(part.triangle, first);
    advance(part.offset_x, first), advance(part.offset_y, first);
    advance(part.red, first), advance(part.green, first), advance(part.blue, first), advance(part.alpha, first);
    advance(part.normal_x, first), advance(part.normal_y, first), advance(part.normal_z, first);
    return part;
}

}  // namespace

std::int32_t shade_with_lists(const Kernels& kernels, const LightReach* reach, const ShadeJob& job, TileScratch& s) {
    if (!reach || job.unlit || job.lit) return kernels.shade(&job);
    std::int32_t not_finite = 0;
    for (std::int32_t first = 0; first < job.count; first += pixels_per_list) {
        ShadeJob part = part_of(job, first);
        LightBox box;
        kernels.bounds(&part, &box);
        reach->in_box(box, &s.tile_lights, s.lights);
        part.lights = s.lights.data();
        part.light_count = std::int32_t(s.lights.size());
        not_finite += kernels.shade(&part);
    }
    return not_finite;
}

}  // namespace rakelight::raster
