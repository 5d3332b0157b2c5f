// SPDX-License-Identifier: Apache-2.0
// Shadow maps: how much of a light reaches a run of pixels. Per instruction set.
#pragma once
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

/// 0..1: how much of light i arrives.
inline real shadow_factor(const ShadeJob& job, int32_t, const Pixels&, const lit::LightSample&) {
    if (job.full->shadows == nullptr) return real(1.0f);
    return real(1.0f);
}

}  // namespace rakelight::raster::RL_ISA
