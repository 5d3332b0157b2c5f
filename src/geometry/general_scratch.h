// SPDX-License-Identifier: Apache-2.0
// Memory of the general path that a workspace keeps for the next call.
#pragma once
#include "geometry/block_array.h"

namespace rakelight::geometry {

/// A stage takes a block and returns it; contents are not preserved.
struct GeneralScratch {
    Block faces;    ///< face normals while grouping, then rows of normals
    Block corners;  ///< corners by place, then rows of tangents
    Block keys;     ///< of CornerSort
    std::size_t bytes() const { return faces.bytes() + corners.bytes() + keys.bytes(); }
};

}  // namespace rakelight::geometry
