// SPDX-License-Identifier: Apache-2.0
// The soft engine: our own rasterizer. The stages, one file each, in the order of the data:
// transform -> clip -> setup -> bins -> coverage + depth (visibility) -> shade -> sink.
#pragma once
#include <memory>
#include <string>

#include <rakelight/engines/engine.h>

namespace rakelight::raster {

/// Makes a soft engine. Bit-identical pictures for any number of threads, instruction set and machine of x86-64.
/// @throws Error usage: RAKELIGHT_ISA names an unknown set or one that this processor lacks.
std::unique_ptr<Engine> make_engine();

/// The instruction set in use: RAKELIGHT_ISA (scalar, sse2, avx2, avx512) or the best that this processor has.
std::string isa_name();

}  // namespace rakelight::raster
