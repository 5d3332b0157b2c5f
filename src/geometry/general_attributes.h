// SPDX-License-Identifier: Apache-2.0
// The general path (attributes.cpp) into the caller's buffers; the form with arrays is in fast_attributes.h.
#pragma once
#include <rakelight/attributes.h>

#include "geometry/block_array.h"

namespace rakelight::geometry {

/// @param out  [meshes] large enough: checked by the caller
/// @throws Error as compute_attributes(); the scratch may then have lost its memory
std::vector<SplitAttributes> general_attributes_into(std::span<const AttributeMesh> meshes,
                                                     const AttributeOptions& options,
                                                     std::span<const AttributeBuffers> out, GeneralScratch& scratch,
                                                     Context& context);

}  // namespace rakelight::geometry
