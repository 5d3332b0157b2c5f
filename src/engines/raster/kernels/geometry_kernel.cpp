// SPDX-License-Identifier: Apache-2.0
// The kernels of geometry and visibility, compiled once per instruction set.
#include "engines/raster/kernels/collect_kernel.h"
#include "engines/raster/kernels/cover_kernel.h"
#include "engines/raster/kernels/depth_kernel.h"
#include "engines/raster/kernels/nearest_kernel.h"
#include "engines/raster/kernels/occlusion_kernel.h"
#include "engines/raster/kernels/record_kernel.h"
#include "engines/raster/kernels/set_up_kernel.h"
#include "engines/raster/kernels/vertex_kernel.h"

namespace rakelight::raster::RL_ISA {

const GeometryKernels* geometry_kernels() {
    static constexpr GeometryKernels table = {transform, set_up,  clear_tile, fill_empty, farthest,  nearest,
                                              cover,     collect, number,     record,     occlusion, smooth_occlusion};
    return &table;
}

}  // namespace rakelight::raster::RL_ISA
