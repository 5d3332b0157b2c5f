// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engines/raster/kernels/geometry_types.h"
#include "math/isa.h"

namespace rakelight::raster {

/// The kernels of every instruction set that this processor has.
inline std::vector<const GeometryKernels*> every_geometry_kernels() {
    std::vector<const GeometryKernels*> all;
    for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512})
        if (is_available(isa)) all.push_back(RL_BY_ISA(isa, geometry_kernels()));
    return all;
}

}  // namespace rakelight::raster
