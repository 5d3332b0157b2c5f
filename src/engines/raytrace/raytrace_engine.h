// SPDX-License-Identifier: Apache-2.0
// The engine trace: rays through the pixels, by Embree, lit by the same kernels as the soft engine's pixels.
#pragma once
#include <memory>

#include <rakelight/engines/engine.h>

namespace rakelight::raytrace {

/// Same bits for any number of threads and any window on one instruction set. From set to set Embree may find another
/// triangle at an edge.
/// @throws Error failed: Embree is not installed; usage: RAKELIGHT_ISA names an unknown set or one that this processor
/// lacks
std::unique_ptr<Engine> make_engine();

}  // namespace rakelight::raytrace
