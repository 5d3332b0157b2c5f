// SPDX-License-Identifier: Apache-2.0
// One vector of pixels with all that is known of it. Per instruction set.
#pragma once
#include "cpu_shading/kernels/whole_points.h"
#include "engines/raster/kernels/shade_pixels.h"

namespace rakelight::raster::RL_ISA {

struct WholePixels : cpu::WholePoints<PixelSource<1>> {
    using WholePoints::WholePoints;
    const Pixels& pixels() const { return source.pixels[0]; }
    SeenByMaps<cpu::EveryMaterial, 1> seen() const { return {source.job, source, b}; }
};

}  // namespace rakelight::raster::RL_ISA
