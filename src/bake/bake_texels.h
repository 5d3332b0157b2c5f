// SPDX-License-Identifier: Apache-2.0
// Computes the texels that LOW's charts cover or touch.
#pragma once
#include <rakelight/bake/bake.h>

namespace rakelight::bake {

/// Fills the maps of `result`, whose size is set, and the texel and chart statistics of its report.
/// @param high  prepared, posed. @param low  prepared, with tangents
/// @param lit HIGH with irradiance as vertex colors; null: no light map
/// @return [height * width] 1: the texel is covered
std::vector<std::uint8_t> bake_texels(const Scene& high, const Scene& low, const Scene* lit, const BakeOptions& options,
                                      BakeResult& result, Context& context);

}  // namespace rakelight::bake
