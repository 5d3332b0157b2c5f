// SPDX-License-Identifier: Apache-2.0
// One vector of points with all that is known of it, whatever kernel draws it: for data channels, and to be explained. Per
// instruction set.
#pragma once
#include "cpu_shading/kernels/shade_points.h"

namespace rakelight::cpu_shading::RL_ISA {

/// Not to be copied: its parts refer to each other. @tparam Source  of one vector, made of a job and its first point
template <class Source>
struct WholePoints {
    Job<EveryMaterial> material;
    Source source;
    Points<EveryMaterial, 1> b;

    WholePoints(const WholePoints&) = delete;
    WholePoints& operator=(const WholePoints&) = delete;
    template <class EnginesJob>
    [[gnu::noinline]] WholePoints(const EnginesJob& job, int32_t first) : material{job}, source(job, first) {
        b.count = 1;
        find_surfaces(material, source, {true, true}, b);
    }
    const PointState<EveryMaterial>& state() const { return b.of[0]; }
    const ShadingPoint& point() const { return b.of[0].point; }
};

}  // namespace rakelight::cpu_shading::RL_ISA
