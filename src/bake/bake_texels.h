// SPDX-License-Identifier: Apache-2.0
// The numbers of all texels that LOW's charts cover or touch.
#pragma once
#include <rakelight/bake.h>

namespace rakelight::bake {

/// Fills the maps of `result`, whose size is set, and what its report counts of texels and charts.
/// @param high  prepared, posed. @param low  prepared, with tangents
/// @param lit   HIGH with the light that arrives as its colors; null: no map shows light
/// @return [height * width] 1: the texel has its numbers
std::vector<std::uint8_t> bake_texels(const Scene& high, const Scene& low, const Scene* lit, const BakeOptions& options,
                                      BakeResult& result, Context& context);

}  // namespace rakelight::bake
