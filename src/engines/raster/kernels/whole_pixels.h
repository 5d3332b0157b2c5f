// SPDX-License-Identifier: Apache-2.0
// One vector of pixels with all that is known of it, whatever kernel draws it: for data channels, and to be explained. Per
// instruction set.
#pragma once
#include "engines/raster/kernels/shade_pixels.h"

namespace rakelight::raster::RL_ISA {

/// Not to be copied: its parts refer to each other.
struct WholePixels {
    cpu::Job<cpu::EveryMaterial> material;
    PixelSource<1> source;
    cpu::Points<cpu::EveryMaterial, 1> b;

    WholePixels(const WholePixels&) = delete;
    WholePixels& operator=(const WholePixels&) = delete;
    [[gnu::noinline]] WholePixels(const ShadeJob& job, int32_t first) : material{job}, source(job, first) {
        b.count = 1;
        cpu::find_surfaces(material, source, {true, true}, b);
    }
    const Pixels& pixels() const { return source.pixels[0]; }
    const cpu::PointState<cpu::EveryMaterial>& state() const { return b.of[0]; }
    const ShadingPoint& point() const { return b.of[0].point; }
    SeenByMaps<cpu::EveryMaterial, 1> seen() const { return {source.job, source, b}; }
};

}  // namespace rakelight::raster::RL_ISA
